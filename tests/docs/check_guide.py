"""Runs what docs/guide.md tells to type: its commands, and the programs that its section on solvers names.

check_guide.py WHAT PREFIX LIBDIR, where WHAT is `commands` or one of the programs. Parts of programs are completed here. A program
that is not installed is skipped (code 77).
"""
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
WHAT, PREFIX, LIBDIR = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
GUIDE = (ROOT / "docs/guide.md").read_text()
ENVIRONMENT = {**os.environ, "PATH": f"{PREFIX}/bin:{os.environ['PATH']}", "WM_PROJECT_DIR": "/usr/share/openfoam",
               "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "HOME": os.getcwd()}
PACKAGES = {"calculix": "calculix-ccx", "dolfinx": "python3-dolfinx-real python3-gmsh", "openfoam": "openfoam", "getdp": "getdp",
            "meshio": "python3-meshio"}
CONTROL = """FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }
startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1; writeInterval 1; writeFormat ascii;
"""
VOLUMES = """
Jacobian { { Name J; Case { { Region All; Jacobian Vol; } } } }
Integration { { Name I; Case { { Type Gauss; Case { { GeoElement Tetrahedron; NumberOfPoints 4; } } } } } }
FunctionSpace { { Name H; Type Form0; BasisFunction { { Name n; NameOfCoef T; Function BF_Node;
    Support Region[{Bone, Marrow}]; Entity NodesOf[All]; } } } }
Formulation { { Name F; Quantity { { Name T; Type Local; NameOfSpace H; } }
    Equation { Galerkin { [Dof{T}, {T}]; In Region[{Bone, Marrow}]; Jacobian J; Integration I; }
               Galerkin { [-1, {T}]; In Region[{Bone, Marrow}]; Jacobian J; Integration I; } } } }
Resolution { { Name R; System { { Name A; NameOfFormulation F; } }
    Operation { Generate[A]; Solve[A]; SaveSolution[A]; } } }
PostProcessing { { Name P; NameOfFormulation F;
    Quantity { { Name V; Value { Integral { [{T}]; In Region[{Bone, Marrow}]; Jacobian J; Integration I; } } } } } }
PostOperation { { Name P; NameOfPostProcessing P; Operation {
    Print[V[Bone], OnGlobal, Format Table, File "bone.txt"]; Print[V[Marrow], OnGlobal, Format Table, File "marrow.txt"]; } } }
"""


def need(program="", *modules):
    if (program and not shutil.which(program)) or not all(importlib.util.find_spec(module) for module in modules):
        print(f"skipped: {WHAT} is not here; Debian has it in {PACKAGES[WHAT]}")
        sys.exit(77)


def block(language):
    """The one fenced block of a language."""
    text, = re.findall(rf"^```{language}\n(.*?)^```$", GUIDE, re.DOTALL | re.MULTILINE)
    return text


def run(line):
    print("$", line, flush=True)
    done = subprocess.run(line, shell=True, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        sys.exit(f"it failed:\n{done.stdout}")
    return done.stdout


def check(holds, what):
    if not holds:
        sys.exit(what)


def write_part():
    """part.nrrd: bone (1) around marrow (2) in air (0)."""
    n, middle = 14, 6.5
    def label(x, y, z):
        square = (x - middle) ** 2 + (y - middle) ** 2 + (z - middle) ** 2
        return 2 if square < 9 else 1 if square < 30 else 0
    voxels = bytes(label(x, y, z) for z in range(n) for y in range(n) for x in range(n))
    header = f"NRRD0004\ntype: uint8\ndimension: 3\nsizes: {n} {n} {n}\nspacings: 1 1 1\nencoding: raw\n\n"
    pathlib.Path("part.nrrd").write_bytes(header.encode() + voxels)


def mesh_volumes(path):
    """Label -> volume, as `cleft info` tells them."""
    rows = re.findall(r"^ +(\d+) +[\d,]+ +([\d.]+) +[\d.]+ %", run(f"cleft info {path}"), re.MULTILINE)
    return {int(label): float(volume) for label, volume in rows}


def check_commands():
    """Each command behind a `$` runs, and prints the lines below it that tell of its input (no times, no figures of meshes)."""
    shutil.copytree(ROOT / "tests/data", "tests/data")
    blocks = re.findall(r"^    \$ (.*)\n((?:    .*\n|\n(?=    ))*)", GUIDE, re.MULTILINE)
    check(len(blocks) >= 2, "the guide has fewer commands than it had")
    for command, wanted in blocks:
        printed = run(command).splitlines()
        for line in wanted.splitlines():
            if re.match(r"    (Volume|Box|Affine) ", line) or " info " in command:
                check(not line.strip() or line[4:] in printed, f"this was not printed: {line}")


def check_meshio():
    need("", "meshio")
    import meshio
    run("cleft mesh part.nrrd -q -o part.vtu")
    line = re.search(r"`(meshio\.read\(.*?)`", GUIDE).group(1)
    labels = eval(line, {"meshio": meshio})
    check(set(map(int, labels[0])) == {0, 1, 2}, "meshio finds other labels")


def check_calculix():
    need("ccx")
    run(re.search(r"`(cleft mesh part\.nrrd --strip 0 -o part\.inp)`", GUIDE).group(1) + " -q --only 1")
    pathlib.Path("job.inp").write_text(block("calculix") + "*STEP\n*STATIC\n*DLOAD\nMATERIAL_1, P1, 0.\n*END STEP\n")
    check("*ERROR" not in run("ccx job"), "CalculiX finds errors")


def check_dolfinx():
    need("", "dolfinx", "gmsh")
    for options in ("", "--msh-version 2.2"):
        run(f"cleft mesh part.nrrd -q {options} -o part.msh")
        pathlib.Path("program.py").write_text(
            block("python") + "print(sorted(set(cells.values)), len(set(facets.values)), len(cells.values))\n")
        volumes = run("cleft info part.msh")
        printed = run(f"{sys.executable} program.py").splitlines()[-1]
        labels, groups, count = re.match(r"(\[.*\]) (\d+) (\d+)", printed).groups()
        # Label 0 has the least number that is free.
        check(labels == "[1, 2, 3]", f"dolfinx finds the labels {labels}")
        check(int(groups) == 2 + 6, f"dolfinx finds {groups} groups of triangles")
        check(f"{int(count):,} tetrahedra" in volumes, f"dolfinx finds {count} tetrahedra")


def check_openfoam():
    need("gmshToFoam")
    os.makedirs("system")
    pathlib.Path("system/controlDict").write_text(CONTROL)
    for line in block("openfoam").splitlines():
        run(line)
    zones = pathlib.Path("constant/polyMesh/cellZones").read_text()
    check(set(re.findall(r"^(\w+)\n\{", zones, re.MULTILINE)) >= {"material_0", "material_1", "material_2"}, zones[:2000])


def check_getdp():
    need("getdp")
    run("cleft mesh part.nrrd -q --msh-version 2.2 --strip 0 -o part.msh")
    pathlib.Path("program.pro").write_text(block("getdp") + VOLUMES)
    run("getdp program.pro -msh part.msh -solve R -pos P")
    for name, volume in zip(("bone", "marrow"), (mesh_volumes("part.msh")[label] for label in (1, 2))):
        found = float(pathlib.Path(name + ".txt").read_text().split()[-1])
        check(abs(found - volume) < 1e-3 * volume, f"GetDP finds the volume {found} of {name}, not {volume}")


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    ENVIRONMENT["HOME"] = folder
    write_part()
    globals()["check_" + WHAT]()
