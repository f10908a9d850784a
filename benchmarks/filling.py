#!/usr/bin/python3
"""Has Gmsh and TetGen fill the interfaces of Cleft's meshes: a table of docs/quality.md.

    benchmarks/filling.py [--cleft build/release/src/cli/cleft] [--only TEXT] [-o docs/quality.md]

They start from surfaces, so they get those that Cleft made, and keep them triangle by triangle. Needs Debian's gmsh,
tetgen and python3-numpy.
"""
import json
import pathlib
import resource
import subprocess
import tempfile

import numpy as np

import quality
import volumes

VOLUMES = ("mickey", "CIT168", "Voronoi grains")
LIMIT = 600  # seconds
REPEAT = 3
COLUMNS = ("volume", "program", "tetrahedra", "least angle", "greatest angle", "below 10, 15, 20", "sound", "CPU s")
CORNERS = np.array([(1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)])


def read_table(path):
    """The rows of a file of TetGen, without their numbers."""
    head, _, body = path.read_text().partition("\n")
    count = int(head.split()[0])
    return np.array(body.split(), float).reshape(count, -1)[:, 1:]


class Surfaces:
    """The interfaces and sides of a mesh: triangles between two regions, each a connected piece of a label. Region 0 is
    the outside of the box.
    """

    def __init__(self, stem):
        self.points = read_table(stem.with_suffix(".node"))
        table = read_table(stem.with_suffix(".ele")).astype(int)
        tets, labels = table[:, :4] - 1, table[:, 4]
        faces = tets[:, CORNERS].reshape(-1, 3)
        order = np.lexsort(np.sort(faces, axis=1).T)
        same = (np.sort(faces, axis=1)[order][1:] == np.sort(faces, axis=1)[order][:-1]).all(1)
        first, second = order[:-1][same], order[1:][same]
        regions = connected(len(tets), first // 4, second // 4, labels)
        outer = np.setdiff1d(np.arange(len(faces)), np.concatenate([first, second]))
        differ = regions[first // 4] != regions[second // 4]
        first, second = first[differ], second[differ]
        self.triangles = np.vstack([faces[first], faces[outer]])
        sides = [regions[first // 4], regions[second // 4]]
        sides = [np.append(sides[0], regions[outer // 4]), np.append(sides[1], np.zeros(len(outer), int))]
        self.sides = np.sort(np.transpose(sides), axis=1)
        self.number = regions.max()
        self.inner = [self.points[tets[np.argmax(regions == region)]].mean(0) for region in range(1, self.number + 1)]
        # Only the points of triangles.
        used, self.triangles = np.unique(self.triangles, return_inverse=True)
        self.points, self.triangles = self.points[used], self.triangles.reshape(-1, 3)


def connected(count, first, second, labels):
    """The number, from 1, of the connected piece of one label that each tetrahedron is in."""
    same = labels[first] == labels[second]
    first, second = first[same], second[same]
    piece = np.arange(count)
    while True:
        new = piece.copy()
        np.minimum.at(new, first, piece[second])
        np.minimum.at(new, second, piece[first])
        new = new[new]
        if (new == piece).all():
            return np.unique(piece, return_inverse=True)[1] + 1
        piece = new


def lines(numbers, rows):
    return "".join("%d %s\n" % (number, " ".join(map(str, row))) for number, row in zip(numbers, rows.tolist()))


def write_tetgen(surfaces, path):
    count = np.arange(1, len(surfaces.points) + 1)
    text = "%d 3 0 0\n%s" % (len(count), lines(count, surfaces.points))
    three = np.full(len(surfaces.triangles), 3)
    text += "%d 0\n%s0\n" % (len(three), lines(three, surfaces.triangles + 1))
    numbers = range(1, surfaces.number + 1)
    rows = ["%d %r %r %r %d\n" % (number, *map(float, point), number) for number, point in zip(numbers, surfaces.inner)]
    path.write_text(text + "%d\n" % surfaces.number + "".join(rows))


def write_gmsh(surfaces, path):
    """A mesh of triangles, and a script that bounds a volume for each region by them."""
    pairs, pair_of = np.unique(surfaces.sides, axis=0, return_inverse=True)
    count = np.arange(1, len(surfaces.points) + 1)
    rows = np.column_stack([np.full((len(pair_of), 2), 2), pair_of + 1, pair_of + 1, surfaces.triangles + 1])
    text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n%d\n%s$EndNodes\n" % (
        len(count),
        lines(count, surfaces.points),
    )
    text += "$Elements\n%d\n%s$EndElements\n" % (len(rows), lines(np.arange(1, len(rows) + 1), rows))
    path.with_suffix(".msh").write_text(text)
    script = 'Merge "%s";\n' % path.with_suffix(".msh").name
    for region in range(1, surfaces.number + 1):
        around = ", ".join(str(pair + 1) for pair in np.nonzero((pairs == region).any(1))[0])
        script += "Surface Loop(%d) = {%s};\nVolume(%d) = {%d};\n" % (region, around, region, region)
        script += "Physical Volume(%d) = {%d};\n" % (region, region)
    path.write_text(script)


# name: the command, and the mesh that it makes. Debian's Gmsh has no optimiser of Netgen.
PROGRAMS = {
    "TetGen, -pYqA": ("tetgen -pYqAQ in.smesh", "in.1.node"),
    "TetGen, -pYq1.2/18O9/7A": ("tetgen -pYq1.2/18O9/7AQ in.smesh", "in.1.node"),
    "Gmsh": ("gmsh -3 in.geo -nt 1 -format msh22 -o out.msh", "out.msh"),
    "Gmsh, -algo hxt": ("gmsh -3 in.geo -nt 1 -algo hxt -format msh22 -o hxt.msh", "hxt.msh"),
}


def cpu_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def cells(cleft, mesh, seconds, folder):
    """What `cleft check` says of a mesh, whether it is valid or not."""
    report = folder / "check.json"
    done = subprocess.run([cleft, "check", mesh, "-q", "--json", report], capture_output=True, text=True)
    found = json.loads(report.read_text())
    shape = found.get("quality")
    if not shape:
        return [done.stderr.strip().splitlines()[-1]] + [""] * 5
    below = "%d, %d, %d" % tuple(shape["tets_below_%d" % angle] for angle in (10, 15, 20))
    tets = "{:,}".format(found["mesh"]["tets"])
    return [
        tets,
        "%.1f" % shape["min_dihedral"],
        "%.1f" % shape["max_dihedral"],
        below,
        "no" if done.returncode else "yes",
        "%.1f" % seconds,
    ]


def least_seconds(run):
    """The least CPU time of some runs, which other programs on the machine disturb least."""
    seconds = []
    for _ in range(REPEAT):
        before = cpu_seconds()
        run()
        seconds.append(cpu_seconds() - before)
    return min(seconds)


def fill(cleft, command, mesh, folder):
    def run():
        subprocess.run(command.split(), cwd=folder, check=True, capture_output=True, timeout=LIMIT)

    try:
        seconds = least_seconds(run)
    except subprocess.TimeoutExpired:
        return ["no end in %d s" % LIMIT] + [""] * 5
    except subprocess.CalledProcessError as error:
        return ["ended by %d" % error.returncode] + [""] * 5
    return cells(cleft, folder / mesh, seconds, folder)


def rows(cleft, files, folder):
    """Cleft's row, and one for each program."""
    command = [cleft, "mesh", *files, "-o", folder / "cleft.node", "-q", "--threads", "1"]
    seconds = least_seconds(lambda: subprocess.run(command, check=True))
    yield "Cleft, from voxels", cells(cleft, folder / "cleft.node", seconds, folder)
    surfaces = Surfaces(folder / "cleft")
    write_tetgen(surfaces, folder / "in.smesh")
    write_gmsh(surfaces, folder / "in.geo")
    for name, (command, mesh) in PROGRAMS.items():
        yield name, fill(cleft, command, mesh, folder)


def add_arguments(parser):
    parser.add_argument("--only", default="", help="volumes whose name contains this text")


def make_table(arguments, generated):
    every = {**volumes.kept(), **generated}
    names = [name for name in VOLUMES if arguments.only in name]
    text = quality.line(COLUMNS) + quality.line(["---"] * len(COLUMNS))
    for name in names:
        with tempfile.TemporaryDirectory() as folder:
            for program, row in rows(arguments.cleft, every[name][0], pathlib.Path(folder)):
                text += quality.line([name, program, *row])
                print(text.splitlines()[-1], flush=True)
    return text


if __name__ == "__main__":
    quality.run_table(__doc__, "filling", make_table, add_arguments)
