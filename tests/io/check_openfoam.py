"""OpenFOAM's gmshToFoam converts the .msh of version 2.2: the cell zones are the materials, the patches the sides of
the box, and each has as many cells and faces as was written."""
import os
import re
import shutil
import subprocess
import sys

from sample import run_checks, same

CONTROL = """FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }
startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1; writeInterval 1; writeFormat ascii;
"""
HOME_OF_DEBIAN = "/usr/share/openfoam"  # what its etc/bashrc would set


def sizes(path, count):
    """Name -> number of elements of each entry of a file of OpenFOAM."""
    text = re.sub(r"/\*.*?\*/|//[^\n]*", "", open(path).read(), flags=re.DOTALL)
    return {name: int(number) for name, number in re.findall(r"(\w+)\s*\{[^{}]*?%s\s*(\d+)" % count, text)}


def check_zones(sample):
    case = sample.path("case")
    os.makedirs(case + "/system")
    with open(case + "/system/controlDict", "w") as file:
        file.write(CONTROL)
    run = subprocess.run(
        ["gmshToFoam", sample.path("msh22.msh"), "-case", case],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        env={"WM_PROJECT_DIR": HOME_OF_DEBIAN, **os.environ},
    )
    faults = [line for line in run.stdout.splitlines() if "ERROR" in line]
    same((run.returncode, faults), (0, []), "complaints of gmshToFoam in\n" + run.stdout)

    mesh = case + "/constant/polyMesh"
    same(
        sizes(mesh + "/cellZones", r"List<label>"),
        {name: len(cells) for name, cells in sample.materials().items()},
        "cell zones",
    )
    patches = {name: size for name, size in sizes(mesh + "/boundary", "nFaces").items() if size}
    same(patches, {name: len(faces) for name, faces in sample.groups().items() if "box" in name}, "patches")
    same(
        sizes(mesh + "/faceZones", r"faceLabels\s+List<label>"),
        {name: len(faces) for name, faces in sample.groups().items() if "interface" in name},
        "face zones",
    )


if not shutil.which("gmshToFoam"):
    print("skipped: gmshToFoam is not here; Debian has it in openfoam")
    sys.exit(77)
run_checks(check_zones)
