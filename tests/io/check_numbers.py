"""The numbers of volumes and of surfaces in a file are disjoint and positive, and positive labels keep theirs, whatever
the labels are; read back, the labels are the same: check_numbers.py WRITE_SAMPLE DUMP_MESH."""
import random

import meshio
import numpy as np

from check_reading import dump
from sample import corners, run_checks, same

LOWEST, GREATEST = -(2**31), 2**31 - 1


def read_lines(path):
    return [line.split() for line in open(path)]


def numbered(cells, numbers):
    """Number -> set of the cells (sorted corners, from 0) that have it."""
    found = {}
    for cell, number in zip(cells, numbers):
        found.setdefault(int(number), set()).add(corners(*cell))
    return found


def section(lines, keyword):
    """The rows of a section of MEDIT, as integers."""
    start = lines.index([keyword])
    return np.array(lines[start + 2 : start + 2 + int(lines[start + 1][0])], dtype=np.int64)


def read_medit(sample):
    lines = read_lines(sample.path("medit.mesh"))
    tets, triangles = section(lines, "Tetrahedra"), section(lines, "Triangles")
    names = {int(row[1]): row[3] for row in lines if row[:1] == ["#"] and row[2:3] == ["="]}
    return numbered(tets[:, :4] - 1, tets[:, 4]), numbered(triangles[:, :3] - 1, triangles[:, 3]), names


def read_tetgen(sample):
    tets = np.array(read_lines(sample.path("tetgen.ele"))[1:], dtype=np.int64)
    lines = read_lines(sample.path("tetgen.face"))
    triangles = np.array([row for row in lines[1:] if row[0] != "#"], dtype=np.int64)
    names = {int(row[1]): row[3] for row in lines if row[0] == "#" and row[2] == "="}
    return numbered(tets[:, 1:5] - 1, tets[:, 5]), numbered(triangles[:, 1:4] - 1, triangles[:, 4]), names


def read_gmsh(name):
    """By meshio: the numbers of physical groups, which must be those of the entities too."""

    def read(sample):
        mesh = meshio.read(sample.path(name))
        point_of = {tuple(point): i for i, point in enumerate(sample.points.tolist())}
        cells = {"tetra": {}, "triangle": {}}
        for block, physical, entities in zip(
            mesh.cells, mesh.cell_data["gmsh:physical"], mesh.cell_data["gmsh:geometrical"]
        ):
            same(physical.tolist(), entities.tolist(), "numbers of entities")
            rows = [[point_of[tuple(point)] for point in cell] for cell in mesh.points[block.data].tolist()]
            for number, found in numbered(rows, physical).items():
                cells[block.type].setdefault(number, set()).update(found)
        names = {int(number): group for group, (number, dimension) in mesh.field_data.items() if dimension == 2}
        return cells["tetra"], cells["triangle"], names

    return read


def check_numbers(sample):
    groups, materials = sample.groups(), sample.materials()
    labels = sorted(set(sample.labels.tolist()))
    own = {label: materials[sample.material(label)] for label in labels}
    for read, keeps_all in (
        (read_medit, True),
        (read_tetgen, True),
        (read_gmsh("msh22.msh"), False),
        (read_gmsh("msh41.msh"), False),
    ):
        tets, triangles, names = read(sample)
        same({names[number]: cells for number, cells in triangles.items()}, groups, "triangles")
        same(sorted(map(sorted, tets.values())), sorted(map(sorted, own.values())), "tetrahedra")
        same(set(tets) & set(triangles), set(), "numbers that volumes and surfaces share")
        for label in labels:
            if label > 0 or keeps_all:
                same(tets.get(label), own[label], "tetrahedra with the number of their label")
        smallest = min(triangles) if keeps_all else min([*tets, *triangles])
        assert 1 <= smallest and max([*tets, *triangles]) <= GREATEST
        if max(tets) + len(groups) <= GREATEST:
            assert min(triangles) > max(tets), "surfaces are to follow the volumes"


def check_labels_read_back(sample):
    for name in ("msh22.msh", "msh41.msh", "medit.mesh", "tetgen.node"):
        points, tets, labels = dump(sample.path(name))
        rows = lambda p, t, l: sorted(
            (sorted(map(tuple, corner)), label) for corner, label in zip(p[t].tolist(), l.tolist())
        )
        same(rows(points, tets, labels), rows(sample.points, sample.tets, sample.labels), "labels of " + name)


if __name__ == "__main__":
    draw = random.Random(4)
    cases = [
        (1, 2, 3),
        (-1, 0, 1),
        (-3, -2, -1),
        (0, 1, 2),
        (1, 3, 1000),
        (LOWEST, 0, GREATEST),
        (1, 2, GREATEST),
        (-1, GREATEST - 1, GREATEST),
        (GREATEST - 25, GREATEST - 20, GREATEST - 13),
        (5, 6, GREATEST - 12),
    ]
    cases += [sorted(draw.sample(range(LOWEST, GREATEST + 1), 3)) for _ in range(3)]
    for case in cases:
        print(case, flush=True)
        run_checks(check_numbers, check_labels_read_back, labels=case)
