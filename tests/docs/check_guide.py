"""Runs the commands of docs/guide.md, and the programs that its section on solvers names.

check_guide.py WHAT PREFIX LIBDIR [--write], where WHAT is `commands` or one of the programs. --write puts what the
commands print and draw today into the guide. Parts of programs are completed here. A program that is not installed is
skipped (code 77).
"""
import difflib
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
ENVIRONMENT = {
    **os.environ,
    "PATH": f"{PREFIX}/bin:{os.environ['PATH']}",
    "WM_PROJECT_DIR": "/usr/share/openfoam",
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "HOME": os.getcwd(),
}
PACKAGES = {
    "calculix": "calculix-ccx",
    "dolfinx": "python3-dolfinx-real python3-gmsh",
    "openfoam": "openfoam",
    "getdp": "getdp",
    "meshio": "python3-meshio",
}
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
    Print[V[Bone], OnGlobal, Format Table, File "bone.txt"];
    Print[V[Marrow], OnGlobal, Format Table, File "marrow.txt"]; } } }
"""


def need(program="", *modules):
    if (program and not shutil.which(program)) or not all(importlib.util.find_spec(module) for module in modules):
        print(f"skipped: {WHAT} is not here; Debian has it in {PACKAGES[WHAT]}")
        sys.exit(77)


def block(language):
    """The one fenced block of a language."""
    (text,) = re.findall(rf"^```{language}\n(.*?)^```$", GUIDE, re.DOTALL | re.MULTILINE)
    return text


def run(line):
    print("$", line, flush=True)
    done = subprocess.run(
        line, shell=True, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    if done.returncode:
        sys.exit(f"it failed:\n{done.stdout}")
    # What the command says of its progress on a slow machine does not belong to the guide.
    return re.sub(r"^cleft: \d+ % after .*\n", "", done.stdout, flags=re.MULTILINE)


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
    """Label -> volume, as `cleft info` reports them."""
    rows = re.findall(r"^ +(\d+) +[\d,]+ +([\d.]+) +[\d.]+ %", run(f"cleft info {path}"), re.MULTILINE)
    return {int(label): float(volume) for label, volume in rows}


def is_measured(line):
    """A line of time or memory, which differs from run to run."""
    return line.startswith(("Time ", "Memory "))


def remade(wanted, printed):
    """The lines of the guide as they are printed today. A line `...` stands for those between the lines before and
    after it.
    """
    gaps = [i for i, line in enumerate(wanted) if line.strip() == "..."]
    if not gaps:
        check(
            len(printed) == len(wanted), "more or fewer lines were printed than the guide has:\n" + "\n".join(printed)
        )
        return [old if is_measured(old) else new for old, new in zip(wanted, printed)]
    head, tail = wanted[: gaps[0]], wanted[gaps[0] + 1 :]
    return remade(head, printed[: len(head)]) + [wanted[gaps[0]]] + remade(tail, printed[len(printed) - len(tail) :])


def check_commands():
    """Each command behind a `$` runs and prints the lines below it, but for times and memory. With --write the guide
    gets them, and docs/images the pictures that they draw.
    """
    shutil.copytree(ROOT / "tests/data", "tests/data")
    transcript = re.compile(r"^    \$ (.*)\n((?:    .*\n|\n(?=    ))*)", re.MULTILINE)
    check(len(transcript.findall(GUIDE)) >= 2, "the guide has fewer commands than it had")

    def lines_of_today(block):
        wanted = [line[4:] for line in block.group(2).splitlines()]
        printed = [line.rstrip() for line in run(block.group(1)).splitlines()]
        return f"    $ {block.group(1)}\n" + "".join(f"    {line}".rstrip() + "\n" for line in remade(wanted, printed))

    def numbers_of_today(row):
        """Of the row above the pictures: `| default: 1,000 tetrahedra | `OPTION`: 2,000 | ... |`."""

        def cell(match):
            options = "" if match.group(1).startswith("default") else match.group(1).strip("`")
            printed = run(f"cleft mesh tests/data/mickey.nrrd {options} -o picture.vtu")
            if options:  # the picture without any is drawn by the first command
                name = options.split()[0].strip("-")
                run(f"cleft render picture.vtu -o {name}.png --cut y=0.5 --size 640x512")
            return f"{match.group(1)}: {re.search(r'([0-9,]+) tetrahedra', printed).group(1)}"

        return re.sub(r"(default|`--[^`]+`): [0-9,]+", cell, row.group(0))

    today = transcript.sub(lines_of_today, GUIDE)
    today = re.sub(r"^\| default: .*$", numbers_of_today, today, flags=re.MULTILINE)
    if "--write" in sys.argv:
        (ROOT / "docs/guide.md").write_text(today)
        for picture in pathlib.Path().glob("*.png"):
            shutil.copy(picture, ROOT / "docs/images")
    else:
        check(
            today == GUIDE,
            "the guide is not as the commands print it; --write mends that:\n"
            + "\n".join(
                difflib.unified_diff(GUIDE.splitlines(), today.splitlines(), "guide.md", "today", n=0, lineterm="")
            ),
        )


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
            block("python") + "print(sorted(set(cells.values)), len(set(facets.values)), len(cells.values))\n"
        )
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
    check(
        set(re.findall(r"^(\w+)\n\{", zones, re.MULTILINE)) >= {"material_0", "material_1", "material_2"}, zones[:2000]
    )


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
