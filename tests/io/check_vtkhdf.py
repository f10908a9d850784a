"""VTKHDF as h5py writes it is read, and damaged files are refused: check_vtkhdf.py WRITE_SAMPLE DUMP_MESH."""
import random
import subprocess
import sys

import h5py
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from sample import run_checks, same

TETRA, TRIANGLE, HEXAHEDRON = 10, 5, 12
POINTS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], float)
TETS = np.array([[0, 1, 2, 3], [1, 4, 2, 3]])


def read(path, folder):
    """What the library says, or the arrays that it reads."""
    run = subprocess.run([sys.argv[2], path, folder], stderr=subprocess.PIPE, text=True)
    if run.returncode:
        assert run.returncode == 1 and run.stderr.count("\n") == 1, (run.returncode, run.stderr)
        return run.stderr.strip()
    same(run.stderr, "", "the reading of " + path)
    return (
        np.fromfile(folder + "/points.f64").reshape(-1, 3),
        np.fromfile(folder + "/tets.i32", "<i4").reshape(-1, 4),
        np.fromfile(folder + "/labels.i32", "<i4"),
    )


def grid_of(parts, arrays=None, cells=None):
    """The data sets of parts, which are pairs of points and tetrahedra; `cells` replaces corners, ends and types."""
    corners, ends, types = cells or (
        [tets.ravel() for _, tets in parts],
        [4 * np.arange(len(tets) + 1) for _, tets in parts],
        [np.full(len(tets), TETRA) for _, tets in parts],
    )
    grid = {
        "NumberOfPoints": np.array([len(points) for points, _ in parts], "i8"),
        "NumberOfCells": np.array([len(some) for some in types], "i8"),
        "NumberOfConnectivityIds": np.array([len(some) for some in corners], "i8"),
        "Points": np.concatenate([points for points, _ in parts]),
        "Connectivity": np.concatenate(corners).astype("i8"),
        "Offsets": np.concatenate(ends).astype("i8"),
        "Types": np.concatenate(types).astype("u1"),
    }
    grid.update({"CellData/" + name: values for name, values in (arrays or {}).items()})
    return grid


def write(path, grid, libver="earliest", kind=np.bytes_("UnstructuredGrid"), version=(1, 0), **options):
    with h5py.File(path, "w", libver=libver) as file:
        group = file.create_group("VTKHDF")
        if kind is not None:
            group.attrs["Type"] = kind
        group.attrs["Version"] = np.array(version)
        for name, values in grid.items():
            # HDF5 packs chunks alone.
            chunked = {} if "NumberOf" in name else options
            group.create_dataset(name, data=values, **chunked)


def write_compact(path, grid):
    write(path, {})
    with h5py.File(path, "a") as file:
        for name, values in grid.items():
            plan = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
            plan.set_layout(h5py.h5d.COMPACT)
            links = h5py.h5p.create(h5py.h5p.LINK_CREATE)
            links.set_create_intermediate_group(True)
            data = h5py.h5d.create(
                file["VTKHDF"].id,
                name.encode(),
                h5py.h5t.py_create(values.dtype),
                h5py.h5s.create_simple(values.shape),
                plan,
                lcpl=links,
            )
            data.write(h5py.h5s.ALL, h5py.h5s.ALL, np.ascontiguousarray(values))


def check_types(sample):
    path = sample.path("types.vtkhdf")
    for integer in ("<i4", ">i8", "<u4", ">i2", "<u8"):
        for real in ("<f8", ">f8", "<f4", ">f4"):
            grid = grid_of([(sample.points.astype(real), sample.tets)])
            for name in ("NumberOfPoints", "Connectivity", "Offsets"):
                grid[name] = grid[name].astype(integer)
            # Labels may also be whole numbers in floating point.
            grid["CellData/material"] = sample.labels.astype(real)
            write(path, grid)
            points, tets, labels = read(path, sample.folder)
            same(points.tolist(), sample.points.astype(real).tolist(), "points as " + real)
            same(tets.tolist(), sample.tets.tolist(), "tetrahedra as " + integer)
            same(labels.tolist(), sample.labels.tolist(), "labels as " + real)


def check_forms(sample):
    """Versions of HDF5, and ways of keeping values."""
    path = sample.path("forms.vtkhdf")
    grid = grid_of([(sample.points, sample.tets)], {"material": sample.labels})
    for libver in ("earliest", ("earliest", "v108"), ("v108", "v108"), "latest"):
        write(path, grid, libver)
        sample.check_tets(*read(path, sample.folder))
    for options in (
        {"chunks": True},
        {"chunks": True, "compression": "gzip"},
        {"chunks": True, "compression": "gzip", "shuffle": True},
        {"chunks": True, "shuffle": True},
    ):
        for libver in ("earliest", "v108"):
            write(path, grid, libver, version=(2, 1), **options)
            sample.check_tets(*read(path, sample.folder))
    # Chunks of one row and two columns, the last ones half empty; many of them, so that the tree has several levels.
    few = grid_of([(POINTS, TETS)], {"material": np.array([3, 7])})
    write(path, few)
    with h5py.File(path, "a") as file:
        del file["VTKHDF/Points"]
        file["VTKHDF"].create_dataset("Points", data=POINTS, chunks=(1, 2), compression="gzip")
    same(read(path, sample.folder)[0].tolist(), POINTS.tolist(), "points in chunks")
    write(path, {name: values for name, values in grid.items() if name != "Connectivity"})
    with h5py.File(path, "a") as file:
        file["VTKHDF"].create_dataset("Connectivity", data=grid["Connectivity"], chunks=(3,))
    sample.check_tets(*read(path, sample.folder))
    # One chunk in the newest form.
    write(path, {}, "latest")
    with h5py.File(path, "a", libver="latest") as file:
        for name, values in few.items():
            file["VTKHDF"].create_dataset(name, data=values, chunks=values.shape, compression="gzip")
    same(read(path, sample.folder)[1].tolist(), TETS.tolist(), "tetrahedra in one chunk each")
    write_compact(path, few)
    same(read(path, sample.folder)[2].tolist(), [3, 7], "labels in the header")


def split(sample, count):
    """Parts with points of their own, and the labels in the order of the parts."""
    parts, labels = [], []
    for p in range(count):
        own = np.arange(len(sample.tets)) % count == p
        used, numbers = np.unique(sample.tets[own], return_inverse=True)
        parts.append((sample.points[used], numbers.reshape(-1, 4)))
        labels.append(sample.labels[own])
    return parts, labels


def geometry(points, tets, labels):
    return sorted(map(repr, np.column_stack([points[tets].reshape(len(tets), 12), labels]).tolist()))


def check_partitions(sample):
    path = sample.path("partitions.vtkhdf")
    parts, labels = split(sample, 3)
    write(path, grid_of(parts, {"material": np.concatenate(labels)}))
    found = read(path, sample.folder)
    same(len(found[0]), len(sample.points), "the number of points")
    same(geometry(*found), geometry(sample.points, sample.tets, sample.labels), "tetrahedra of three partitions")
    # VTK reads the same from this file, but does not join points.
    reader = vtk.vtkHDFReader()
    reader.SetFileName(path)
    reader.Update()
    output = reader.GetOutput()
    grid = output if output.IsA("vtkUnstructuredGrid") else output.GetPartition(0)
    path = sample.path("others.vtkhdf")  # VTK has not closed the file yet
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    material = vtk_to_numpy(grid.GetCellData().GetArray("material"))
    same(
        geometry(vtk_to_numpy(grid.GetPoints().GetData()), corners, material),
        geometry(*found),
        "tetrahedra as VTK has them",
    )
    # The second partition repeats the first tetrahedron of the first one.
    points, tets = parts[1]
    parts[1] = (np.concatenate([points, parts[0][0][parts[0][1][0]]]), np.vstack([tets, len(points) + np.arange(4)]))
    labels[1] = np.append(labels[1], labels[0][0])
    ghosts = [np.zeros(len(some), "u1") for some in labels]
    ghosts[1][-1] = 1
    arrays = {"material": np.concatenate(labels), "vtkGhostType": np.concatenate(ghosts)}
    write(path, grid_of(parts, arrays))
    same(geometry(*read(path, sample.folder)), geometry(*found), "tetrahedra beside ghosts")
    # Points of one partition stay apart, even if they are equal.
    twice = np.concatenate([POINTS[:4], POINTS[1:]])
    write(path, grid_of([(twice, np.array([[0, 1, 2, 3], [4, 7, 5, 6]]))]))
    same(len(read(path, sample.folder)[0]), 8, "the number of points of a mesh with a crack")


def check_labels(sample):
    path = sample.path("labels.vtkhdf")
    parts = [(POINTS, TETS)]
    numbers = np.array([5, 6], "i2")
    for arrays, labels in (
        ({}, [0, 0]),
        ({"b": numbers, "c": np.array([1, 2])}, [5, 6]),
        ({"a": np.array([0.5, 1]), "b": numbers}, [5, 6]),
        ({"a": np.zeros((2, 3)), "b": numbers}, [5, 6]),
        ({"a": np.array([b"x", b"y"]), "b": numbers, "vtkGhostType": np.zeros(2, "u1")}, [5, 6]),
        ({"a": np.array([1, 2]), "material": np.array([[8], [-9]])}, [8, -9]),
    ):
        write(path, grid_of(parts, arrays))
        same(read(path, sample.folder)[2].tolist(), labels, "labels")
    for bad in (np.array([0.5, 1]), np.zeros((2, 3)), np.array([b"x", b"y"]), np.array([2**40, 1])):
        write(path, grid_of(parts, {"material": bad}))
        assert "the array 'material' must hold one whole number" in read(path, sample.folder)


def check_cells(sample):
    path = sample.path("cells.vtkhdf")
    corners, ends, types = [[0, 1, 2, 0, 1, 2, 3]], [[0, 3, 7]], [[TRIANGLE, TETRA]]
    write(path, grid_of([(POINTS, None)], {"material": np.array([1, 2])}, (corners, ends, types)))
    points, tets, labels = read(path, sample.folder)
    same((tets.tolist(), labels.tolist()), ([[0, 1, 2, 3]], [2]), "the tetrahedron beside a triangle")
    types = [[TRIANGLE, HEXAHEDRON]]
    write(path, grid_of([(POINTS, None)], {}, (corners, ends, types)))
    assert "the 2nd cell is no tetrahedron but of VTK's type 12" in read(path, sample.folder)


def check_refused(sample):
    path = sample.path("refused.vtkhdf")
    good = grid_of([(POINTS, TETS)], {"material": np.array([3, 7])})
    changed = lambda name, values: {**good, name: np.array(values)}
    for grid, options, sentence in (
        (
            good,
            {"kind": np.bytes_("ImageData")},
            "and this is 'ImageData': in ParaView, save its data as .vtk (legacy)",
        ),
        (good, {"kind": np.bytes_("PolyData")}, "and this is 'PolyData': it is a surface: make a label map of it"),
        (good, {"kind": np.bytes_("MultiBlock")}, "'MultiBlock': in ParaView, save the tetrahedra in it as .vtu"),
        (good, {"kind": None}, "the attribute 'Type' is missing"),
        (good, {"kind": "UnstructuredGrid"}, "the attribute 'Type' is no text of fixed length"),
        (good, {"version": (3, 0)}, "it is VTKHDF of version 3, and only 1 and 2 can be read"),
        (good, {"compression": "lzf"}, "packed by filter 32000 of HDF5"),
        (good, {"fletcher32": True}, "packed by filter 3 of HDF5"),
        (changed("Points", np.full((5, 3), np.nan)), {}, "a coordinate is not finite"),
        (changed("Points", np.zeros((5, 2))), {}, "'Points' has 5 x 2 numbers instead of 5 x 3"),
        (changed("Points", np.zeros((4, 3))), {}, "'Points' has 4 x 3 numbers instead of 5 x 3"),
        (changed("Points", [b"x"] * 5), {}, "the data set 'Points' has no numbers"),
        (changed("Connectivity", np.arange(8) / 2), {}, "the data set 'Connectivity' has no whole numbers"),
        (changed("Connectivity", [0, 1, 2, 3, 1, 5, 2, 3]), {}, "names point 5 of the 5 that are counted from 0"),
        (changed("Connectivity", [0, 1, 2, 3, 1, -1, 2, 3]), {}, "names point -1 of the 5"),
        (changed("Offsets", [0, 5, 8]), {}, "the 1st cell does not have four corners"),
        (changed("Offsets", [0, 4, 7]), {}, "the offsets of the 1st partition do not fit its corners"),
        (changed("Offsets", [0, 2**62, 8]), {}, "an offset of the 1st partition is outside of it"),
        (changed("NumberOfPoints", [-1]), {}, "'NumberOfPoints' is no number of points"),
        (changed("NumberOfCells", [2**62]), {}, "'NumberOfCells' is no number of points"),
        (changed("NumberOfPoints", [2**31]), {}, "it has more points or cells than 32 bits count"),
        (changed("NumberOfCells", [2, 0]), {}, "its lists of partitions have different lengths"),
        (changed("Types", [10, 10, 10]), {}, "'Types' has 3 x 1 numbers instead of 2 x 1"),
        ({name: values for name, values in good.items() if name != "Types"}, {}, "'Types' is missing"),
    ):
        write(path, grid, **options)
        said = read(path, sample.folder)
        assert isinstance(said, str) and sentence in said and path in said, (sentence, said)
    write(path, {name: values for name, values in good.items() if name != "Points"}, "latest")
    with h5py.File(path, "a", libver="latest") as file:
        file["VTKHDF"].create_dataset("Points", data=POINTS, chunks=(2, 3))
    assert "in several chunks in the newest form of HDF5" in read(path, sample.folder)
    for steps in (1, 2):
        write(path, good)
        with h5py.File(path, "a") as file:
            file["VTKHDF"].create_group("Steps").attrs["NSteps"] = steps
        said = read(path, sample.folder)
        assert steps == 1 and len(said) == 3 or "it has several steps of time" in said
    many = {**good, "PointData/a": np.zeros(5), "FieldData/a": np.zeros(1)}
    write(path, many, "latest")
    assert "more than eight members in the newest form" in read(path, sample.folder)
    with h5py.File(path, "w") as file:
        file["labels"] = np.zeros((2, 2, 2))
    assert "this HDF5 file has no group 'VTKHDF'" in read(path, sample.folder)
    with open(path, "w") as file:
        file.write("no mesh")
    assert "this is no HDF5 file" in read(path, sample.folder)
    # Values that no one wrote.
    write(path, changed("Points", []))
    for options in ({}, {"chunks": (2, 3)}):
        with h5py.File(path, "a") as file:
            del file["VTKHDF/Points"]
            file["VTKHDF"].create_dataset("Points", (5, 3), **options)
        assert "has no values" in read(path, sample.folder)


def check_damaged(sample):
    """Cut, and with bytes changed: one sentence, or a mesh; and no mesh where values are missing."""
    path, whole = sample.path("damaged.vtkhdf"), sample.path("whole.vtkhdf")
    grid = grid_of([(POINTS, TETS)], {"material": np.array([3, 7])})
    chance = random.Random(1)
    for libver, options in (("earliest", {}), ("v108", {}), ("earliest", {"chunks": True, "compression": "gzip"})):
        write(whole, grid, libver, **options)
        data = open(whole, "rb").read()
        for cut in range(0, len(data), 211):
            with open(path, "wb") as file:
                file.write(data[:cut])
            assert isinstance(read(path, sample.folder), str)
        for _ in range(30):
            bad = bytearray(data)
            for _ in range(chance.randint(1, 3)):
                bad[chance.randrange(len(bad))] = chance.choice([0, 1, 255, chance.randrange(256)])
            with open(path, "wb") as file:
                file.write(bad)
            read(path, sample.folder)


if __name__ == "__main__":
    run_checks(
        check_types,
        check_forms,
        check_partitions,
        check_labels,
        check_cells,
        check_refused,
        check_damaged,
    )
