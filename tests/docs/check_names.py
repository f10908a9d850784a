"""Do the links of all pages lead somewhere, and do the files exist that pages and comments of the code name?

check_names.py. Prints each link and name that leads nowhere.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("benchmarks/", "bindings/", "docs/", "examples/", "include/", "src/", "tests/", "tools/")
PLACEHOLDER = re.compile(r"NAME|PROGRAM|\*")  # in recipes and patterns
SPECIFICATIONS = {"metaTypes.h", "nifti1.h"}  # of others, which define a format
SOURCE_NAME = re.compile(r"(?<![\w./<\"])((?:[\w-]+/)*[\w-]+\.(?:hpp|cpp|h))\b(?!\")")


def tracked_files():
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, stdout=subprocess.PIPE, text=True)
    if listed.returncode:  # an unpacked source archive
        return [
            path.relative_to(ROOT).as_posix()
            for folder in FOLDERS
            for path in (ROOT / folder).rglob("*")
            if path.is_file()
        ] + [path.name for path in ROOT.glob("*.md")]
    return [name for name in listed.stdout.splitlines() if (ROOT / name).exists()]


def prose(page):
    return re.sub(r"^```.*?^```$", "", page.read_text(), flags=re.DOTALL | re.MULTILINE)


def anchors(page):
    """What `#...` may follow the name of a page: its headings, as GitHub writes them."""
    headings = re.findall(r"^#+ (.*)$", prose(page), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def dead_links(page):
    for target in re.findall(r"\]\(([^)\s]+)\)", prose(page)):
        path, _, anchor = target.partition("#")
        goal = page.parent / path if path else page
        if target.startswith(("http:", "https:")):
            continue
        if not goal.exists() or (anchor and anchor not in anchors(goal)):
            yield f"a link to {target}"


def lost_paths(page):
    """Pieces of code in the prose that are paths of this repository."""
    for name in re.findall(r"`([^`\n]+)`", prose(page)):
        if name.startswith(FOLDERS) and " " not in name and not PLACEHOLDER.search(name) and not (ROOT / name).exists():
            yield f"the path {name}"


def lost_sources(source, names):
    """Sources that its comments name, by their name alone or with folders before it."""
    for comment in re.findall(r"//.*$", source.read_text(), re.MULTILINE):
        for name in SOURCE_NAME.findall(comment):
            if name not in SPECIFICATIONS and not any(known == name or known.endswith("/" + name) for known in names):
                yield f"the source {name}"


def main():
    names = tracked_files()
    found = []
    for name in names:
        path = ROOT / name
        if name.endswith(".md"):
            found += [f"{name}: {what}" for what in (*dead_links(path), *lost_paths(path))]
        elif re.fullmatch(r"(src|include|tests)/.*\.(cpp|hpp|c|h)", name):
            found += [f"{name}: {what}" for what in lost_sources(path, names)]
    if found:
        sys.exit("These lead nowhere:\n" + "\n".join(found))
    if len(names) < 100:
        sys.exit("there are too few files to be true")


main()
