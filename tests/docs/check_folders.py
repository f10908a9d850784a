"""check_folders.py SOURCES: whether each folder includes files of those alone that come before it.

The order is that in which SOURCES/CMakeLists.txt adds the folders of the core. The components beside the core see what
architecture.md says.
"""
import pathlib
import re
import sys

SOURCES = pathlib.Path(sys.argv[1])
BESIDE = {"io": {"base", "io"}, "cli": {"base", "cli"}, "mpi": {"base", "parts", "io", "cli", "mpi"}}


def folders_of_core():
    text = (SOURCES / "CMakeLists.txt").read_text()
    return ["base"] + re.search(r"foreach\(folder ([^)]*)\)", text)[1].split()


def includes_of(folder):
    """(path, folder) for each file of this project that a file of the folder includes."""
    for path in sorted((SOURCES / folder).rglob("*.[ch]pp")):
        for included in re.findall(r'^#include "(\w+)/', path.read_text(), re.MULTILINE):
            if included != "cleft":
                yield path, included


core = folders_of_core()
allowed = {folder: set(core[: place + 1]) for place, folder in enumerate(core)}
allowed.update(BESIDE)
found = {path.name for path in SOURCES.iterdir() if path.is_dir() and any(path.rglob("*.cpp"))}
faults = ["%s: src/%s is in no order" % (SOURCES / "CMakeLists.txt", name) for name in sorted(found - set(allowed))]
looked_at = 0
for folder in allowed:
    for path, included in includes_of(folder):
        looked_at += 1
        if included not in allowed[folder]:
            faults.append("%s: includes a file of %s, which comes later" % (path, included))
if looked_at < 100:
    faults.append("%s: only %d includes were found" % (SOURCES, looked_at))
print("\n".join(faults))
sys.exit(1 if faults else 0)
