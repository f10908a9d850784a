#!/usr/bin/python3
"""Formats the sources, and tells what must be mended by hand: lines that are too long.

    tools/format.py [FILE...]           formats the files, or all of the repository
    tools/format.py --check [FILE...]   changes nothing, and fails if a file is not formatted

clang-format has C and C++ (.clang-format), black has Python (pyproject.toml), findent has the indents of Fortran. All
texts have LF at the ends of lines, no blanks before it, and no tabs. Java and C# have indents of four. CONTRIBUTING.md
says why they and CMake have no more rules than that.
"""
import concurrent.futures
import os
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
WIDTH = 120
FINDENT = ("findent", "-ifree", "-i2", "-k2", "--align_paren=0")
# What each tool formats, by the ends of names.
C = (".c", ".cpp", ".h", ".hpp")
PYTHON = (".py", ".pyi")
FORTRAN = (".f90",)
JAVA_LIKE = (".java", ".cs")
SCRIPTS = (".cmake", "CMakeLists.txt", ".sh", "run-tests", "run-demo")
# Lines within the width; documents have tables.
WITHIN_WIDTH = (*C, *PYTHON, *FORTRAN, *JAVA_LIKE, *SCRIPTS, ".js", ".mjs", ".css")
TEXTS = (*WITHIN_WIDTH, ".html", ".i", ".in", ".inc", ".json", ".md", ".toml")
INPUTS = ("tests/data/", "tests/fuzz/corpus/")  # byte for byte


def all_files():
    listed = subprocess.run(
        ("git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"),
        cwd=ROOT,
        check=True,
        capture_output=True,
    )
    names = sorted(set(listed.stdout.decode().split("\0")) - {""})
    return [name for name in names if not name.startswith(INPUTS) and (ROOT / name).is_file()]


def of_kind(names, ends):
    return [name for name in names if name.endswith(ends)]


def parts(names, count):
    return [part for part in (names[first::count] for first in range(count)) if part]


def run(command, names):
    """What a tool says of the files, if it fails."""
    done = subprocess.run((*command, *names), cwd=ROOT, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return done.stdout.splitlines() if done.returncode else []


def clang_format(names, is_check):
    return run(("clang-format", *(("--dry-run", "--Werror") if is_check else ("-i",))), names)


def black(names, is_check):
    return run(("black", "--quiet", *(("--diff", "--check") if is_check else ())), names)


def put(name, old, new, is_check):
    """Writes what a file should be, or says that it is not so."""
    if new == old:
        return []
    if is_check:
        lines = zip(old.split(b"\n"), new.split(b"\n"))
        first = next((number for number, (a, b) in enumerate(lines, 1) if a != b), old.count(b"\n"))
        return [f"{name}:{first}: not formatted"]
    (ROOT / name).write_bytes(new)
    return []


def findent(names, is_check):
    said = []
    for name in names:
        old = (ROOT / name).read_bytes()
        new = subprocess.run(FINDENT, input=old, check=True, capture_output=True).stdout
        said += put(name, old, new, is_check)
    return said


def faults(name, line):
    """What is wrong with a line and has no rule that mends it."""
    # Rows of tables, commands and what they print cannot be wrapped.
    is_prose = name.endswith(".md") and not line.startswith(("|", "    ", "<", "["))
    if (name.endswith(WITHIN_WIDTH) or is_prose) and len(line) > WIDTH:
        yield f"{len(line)} columns; there must be {WIDTH} at most"
    indent = len(line) - len(line.lstrip())
    if name.endswith(JAVA_LIKE) and indent % 4 and not line.lstrip().startswith("*"):
        yield f"an indent of {indent}; it must be a multiple of 4"


def text(names, is_check):
    said = []
    for name in names:
        old = (ROOT / name).read_bytes()
        lines = [line.rstrip() for line in old.decode().expandtabs(4).split("\n")]
        new = "\n".join(lines).rstrip("\n") + "\n" if old else ""
        said += put(name, old, new.encode(), is_check)
        said += [f"{name}:{number}: {fault}" for number, line in enumerate(lines, 1) for fault in faults(name, line)]
    return said


# Texts come last: the other tools have broken long lines by then.
STEPS = ((clang_format, C), (black, PYTHON), (findent, FORTRAN), (text, TEXTS))


def main():
    is_check = "--check" in sys.argv[1:]
    given = [argument for argument in sys.argv[1:] if argument != "--check"]
    if any(argument.startswith("-") for argument in given):
        sys.exit(__doc__)
    names = [str(pathlib.Path(name).resolve().relative_to(ROOT)) for name in given] or all_files()
    missing = [tool for tool in ("clang-format", "black", "findent") if not shutil.which(tool)]
    if missing:
        sys.exit(f"tools/format.py needs the Debian packages {', '.join(missing)}")
    said = []
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for step, ends in STEPS:
            jobs = parts(of_kind(names, ends), 1 if step is black else os.cpu_count())  # black has its own processes
            for answer in pool.map(lambda part, step=step: step(part, is_check), jobs):
                said += answer
    print("\n".join(said), end="\n" if said else "")
    if said:
        sys.exit("run tools/format.py" + ("" if is_check else " again after mending these by hand"))


if __name__ == "__main__":
    main()
