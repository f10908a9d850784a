#!/usr/bin/python3
"""Makes what would be transcription: from src/capi/options.toml and the C headers, the files below and the regions in
them.

    tools/generate.py            writes what changed, and names it
    tools/generate.py --check    writes nothing, and fails if anything would change

Made files say so at their head, made regions in files written by hand lie between the marks <name> and </name>. They
are committed: whoever builds needs no generator. A new kind of output is a module in tools/generator with a function
files(tree, table), which gives the contents of files by their paths.
"""
import pathlib
import sys

from generator import c, csharp, exceptions, fortran, guide, java, layout, option_table, python

MAKERS = (c, fortran, layout, java, csharp, exceptions, python, guide)  # in order: each sees what those before it made


class Tree:
    """The files of the repository, with what was made in the place of what is there."""

    def __init__(self, root):
        self.root = root
        self.made = {}

    def read(self, path):
        return self.made[path] if path in self.made else (self.root / path).read_text(encoding="utf-8")


def generate(root):
    """{path: what should be in the file}, of all that is made."""
    tree, table = Tree(root), option_table.read(root)
    for maker in MAKERS:
        tree.made |= maker.files(tree, table)
    return tree.made


def main():
    root, is_check = pathlib.Path(__file__).resolve().parents[1], sys.argv[1:] == ["--check"]
    if sys.argv[1:] and not is_check:
        sys.exit(__doc__)
    try:
        made = generate(root)
    except ValueError as error:
        # What the sources lack is said in a sentence; a traceback would hide it.
        sys.exit(f"tools/generate.py: {error}")
    changed = []
    for path, content in made.items():
        file = root / path
        if not file.exists() or file.read_bytes() != content.encode():
            changed.append(path)
            if not is_check:
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(content, encoding="utf-8")
    print("\n".join(changed) or "nothing changed")
    if is_check and changed:
        sys.exit("these files are not what tools/generate.py makes: run it, and review what changes")


if __name__ == "__main__":
    main()
