"""Does a shared library show the reviewed functions, and nothing else? check_exports.py LIBRARY VERSION_SCRIPT HEADER
NEEDED...

HEADER may be several, with commas between them. The version script is the reviewed list. It, the prototypes of the
header and the symbols of the library must name the same functions; a function that the header has since 0.1 must be in
the node ..._0.1. If NEEDED (names without version) are given, the library may need no others.
"""
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))

from generator import c_header  # noqa: E402


def listed(path):
    """Function -> the version under which the script lists it."""
    text = re.sub(r"/\*.*?\*/", "", open(path).read(), flags=re.S)
    found = {}
    for version, body in re.findall(r"(\w+_[\d.]+) \{\s*global:(.*?)(?:local:.*?)?\}", text, re.S):
        found.update((name, version) for name in re.findall(r"\w+", body))
    return found


def declared(paths):
    """Function -> the release that its comment names."""
    return {function.name: function.since for function in c_header.read(*paths.split(",")).functions}


def exported(path):
    lines = subprocess.run(["nm", "-D", "--defined-only", path], check=True, capture_output=True, text=True).stdout
    # The nodes themselves are absolute symbols.
    symbols = [line.split()[1:] for line in lines.splitlines() if line.split()[1] != "A"]
    return {name.split("@")[0]: name.split("@")[-1] for _, name in symbols}


def needed(path):
    lines = subprocess.run(["readelf", "-d", path], check=True, capture_output=True, text=True).stdout
    return {name.split(".so")[0] for name in re.findall(r"\(NEEDED\).*\[(.*)\]", lines)}


def main():
    library, script, header, *allowed = sys.argv[1:]
    reviewed, prototypes, symbols = listed(script), declared(header), exported(library)
    faults = []
    if symbols != reviewed:
        faults += [
            f"{name}: {reviewed.get(name, 'not')} in the version script, {symbols.get(name, 'not')} in the library"
            for name in sorted(set(symbols) | set(reviewed))
            if symbols.get(name) != reviewed.get(name)
        ]
    for name in sorted(set(prototypes) ^ set(reviewed)):
        faults.append(f"{name} is in {'the version script' if name in reviewed else 'the header'} alone")
    for name in sorted(set(prototypes) & set(reviewed)):
        if not reviewed[name].endswith("_" + prototypes[name]):
            faults.append(f"{name} is there since {prototypes[name]}, but listed in {reviewed[name]}")
    for name in sorted(needed(library) - set(allowed)) if allowed else ():
        faults.append(f"the library needs {name}")
    if not reviewed:
        faults.append(f"{script} lists nothing")
    print("\n".join(faults) or f"{len(symbols)} functions")
    sys.exit(bool(faults))


main()
