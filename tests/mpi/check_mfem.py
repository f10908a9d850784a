"""Reads the parts for MFEM that the runs of mpi_mesh left, by the grammar of MFEM's own reader, glues them by their
groups alone, and compares the result with the mesh of one process: check_mfem.py FOLDER."""
import collections
import itertools
import pathlib
import sys

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

RANKS = (1, 2, 3, 4, 7, 8)
TRIANGLE, TETRAHEDRON = 2, 4  # Geometry::Type
SHARED = {"vertices": 1, "edges": 2, "faces": 3}  # corners of each
folder = pathlib.Path(sys.argv[1])


class Words:
    """The words of a file behind its first line, and its comments."""

    def __init__(self, path):
        head, *lines = path.read_text().split("\n")
        assert head == "MFEM mesh v1.2", head
        self.words = " ".join(line for line in lines if not line.startswith("#")).split()
        self.comments = [line[2:] for line in lines if line.startswith("#")]
        self.at = 0

    def expect(self, word):
        assert self.words[self.at] == word, (self.words[self.at], word)
        self.at += 1

    def number(self):
        self.at += 1
        return int(self.words[self.at - 1])

    def numbers(self, rows, columns, kind=int):
        self.at += rows * columns
        return [kind(word) for word in self.words[self.at - rows * columns : self.at]]

    def rows(self, columns):
        count = self.number()
        return numpy.array(self.numbers(count, columns), int).reshape(-1, columns)


class Part:
    def __init__(self, path, rank):
        words = Words(path)
        words.expect("dimension")
        assert words.number() == 3
        words.expect("elements")
        self.tets = words.rows(6)
        words.expect("boundary")
        self.triangles = words.rows(5)
        words.expect("vertices")
        count, dimension = words.number(), words.number()
        assert dimension == 3
        self.points = numpy.array(words.numbers(count, 3, float)).reshape(-1, 3)
        assert (self.tets[:, 1] == TETRAHEDRON).all() and (self.triangles[:, 1] == TRIANGLE).all()
        assert set(self.tets[:, 2:].ravel()) == set(range(count)), "vertices are those of tetrahedra"
        words.expect("mfem_serial_mesh_end")
        words.expect("communication_groups")
        words.expect("number_of_groups")
        self.groups = [tuple(words.numbers(1, words.number())) for _ in range(words.number())]
        assert self.groups[0] == (rank,) and len(set(self.groups)) == len(self.groups)
        assert all(rank in group and list(group) == sorted(group) for group in self.groups)
        totals = {}
        for kind in SHARED:
            words.expect(f"total_shared_{kind}")
            totals[kind] = words.number()
        self.shared = {kind: {} for kind in SHARED}
        for group in self.groups[1:]:
            for kind, corners in SHARED.items():
                words.expect(f"shared_{kind}")
                # A face has its kind before its corners.
                rows = words.rows(corners + (kind == "faces"))
                assert kind != "faces" or (rows[:, 0] == TRIANGLE).all()
                self.shared[kind][group] = rows[:, -corners:]
        assert all(sum(map(len, groups.values())) == totals[kind] for kind, groups in self.shared.items())
        words.expect("mfem_mesh_end")
        assert words.at == len(words.words)
        self.names = dict(line.split(" = ") for line in words.comments if " = " in line)


def glued(parts):
    """For each part, the numbers of its vertices in the whole: each is that of the first rank that shares it."""
    starts = numpy.cumsum([0] + [len(part.points) for part in parts])
    numbers = numpy.arange(starts[-1])
    for rank, part in enumerate(parts):
        for group, rows in part.shared["vertices"].items():
            first = parts[group[0]].shared["vertices"][group]
            assert len(first) == len(rows), (rank, group)
            numbers[starts[rank] + rows[:, 0]] = starts[group[0]] + first[:, 0]
    return [numbers[starts[rank] : starts[rank + 1]] for rank in range(len(parts))]


def check_groups(parts, numbers):
    """All ranks of a group list the same in the same order, and all that ranks share is listed."""
    for kind, corners in SHARED.items():
        holders = collections.defaultdict(set)
        for rank, part in enumerate(parts):
            for tet in numbers[rank][part.tets[:, 2:]]:
                for entity in itertools.combinations(sorted(tet), corners):
                    holders[entity].add(rank)
        wanted = {entity: tuple(sorted(ranks)) for entity, ranks in holders.items() if len(ranks) > 1}
        for rank, part in enumerate(parts):
            listed = {}
            for group, rows in part.shared[kind].items():
                # Not sorted: the corners of an edge or a triangle have one order on all ranks.
                entities = numbers[rank][rows].tolist()
                first = numbers[group[0]][parts[group[0]].shared[kind][group]].tolist()
                assert entities == first, (kind, rank, group)
                listed.update((tuple(sorted(entity)), group) for entity in entities)
            assert listed == {entity: group for entity, group in wanted.items() if rank in group}, (kind, rank)
        assert kind != "faces" or all(len(group) == 2 for group in wanted.values())


def volume(a, b, c, d):
    return numpy.dot(numpy.cross(b - a, c - a), d - a)


def label_of(word):
    return -int(word[5:]) if word.startswith("minus") else int(word)


def check_boundary(points, tets, labels, triangles, names):
    """Interfaces and the hull, each triangle once, named by its labels and wound as the names say."""
    beside = collections.defaultdict(list)
    for tet, label in zip(tets.tolist(), labels.tolist()):
        for corner in tet:
            beside[tuple(sorted(set(tet) - {corner}))].append((label, corner))
    wanted = {face for face, sides in beside.items() if len({label for label, _ in sides}) > 1 or len(sides) == 1}
    assert len(triangles) == len(wanted)
    for attribute, _, *corners in triangles.tolist():
        face = tuple(sorted(corners))
        assert face in wanted
        sides = sorted(beside[face])
        name = names[str(attribute)]
        a, b, c = points[corners]
        # The tetrahedron of the lower label lies behind the triangle.
        assert volume(a, b, c, points[sides[0][1]]) < 0
        if len(sides) == 2:
            assert name.startswith("interface_"), name
            assert [label_of(word) for word in name.split("_")[1:]] == [label for label, _ in sides]
        else:
            kind, axis, end, label = name.split("_")
            assert kind == "box" and label_of(label) == sides[0][0]
            axis, normal = "xyz".index(axis), numpy.cross(b - a, c - a)
            assert abs(normal[axis]) > 0.999 * numpy.linalg.norm(normal) and (normal[axis] > 0) == (end == "max")


def check(suffix, ranks, whole):
    parts = [Part(folder / f"{ranks}{suffix}.mfem.{rank:06}", rank) for rank in range(ranks)]
    numbers = glued(parts)
    check_groups(parts, numbers)
    names = parts[0].names
    assert all(part.names == names for part in parts)
    points = numpy.concatenate([part.points for part in parts])
    # Glued vertices have one place, and those of one place are glued.
    for rank, part in enumerate(parts):
        assert numpy.array_equal(points[numbers[rank]], part.points)
    used = numpy.unique(numpy.concatenate(numbers))
    assert len(numpy.unique(points[used], axis=0)) == len(used)
    tets = numpy.concatenate([numbers[rank][part.tets[:, 2:]] for rank, part in enumerate(parts)])
    attributes = numpy.concatenate([part.tets[:, 0] for part in parts])
    # Labels above 0 are their own numbers; the others have numbers that no label has.
    numbers_of = {number: label_of(name[9:]) for number, name in names.items() if name.startswith("material_")}
    labels = numpy.array([numbers_of[str(number)] for number in attributes.tolist()])
    assert (attributes[labels > 0] == labels[labels > 0]).all() and (attributes > 0).all()
    rows = lambda p, t, l: sorted(map(repr, numpy.column_stack([p[t].reshape(-1, 12), l]).tolist()))
    assert rows(points, tets, labels) == rows(*whole)
    triangles = numpy.concatenate(
        [
            numpy.column_stack([part.triangles[:, :2], numbers[rank][part.triangles[:, 2:]]])
            for rank, part in enumerate(parts)
        ]
    )
    check_boundary(points, tets, labels, triangles, names)
    return names


def read_whole(path, reader):
    reader.SetFileName(str(folder / path))
    reader.Update()
    grid = reader.GetOutput()
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    return vtk_to_numpy(grid.GetPoints().GetData()), corners, vtk_to_numpy(grid.GetCellData().GetArray("material"))


for suffix, whole in (
    ("", read_whole("1.vtu", vtk.vtkXMLUnstructuredGridReader())),
    ("g", read_whole("1.vtu", vtk.vtkXMLUnstructuredGridReader())),
    ("one", read_whole("1one.hdf", vtk.vtkHDFReader())),
):
    names = [check(suffix, ranks, whole) for ranks in RANKS]
    assert all(others == names[0] for others in names)
    print(suffix, names[0])
print("all alike")
