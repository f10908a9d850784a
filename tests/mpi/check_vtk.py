"""Has VTK read the files that the runs of mpi_mesh left, and compares them with the mesh of one process."""
import hashlib
import pathlib
import sys

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

RANKS = (1, 2, 3, 4, 7, 8)
folder = pathlib.Path(sys.argv[1])


def read(reader, path):
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def arrays(grid):
    """Points, corners of tetrahedra, materials."""
    assert set(vtk_to_numpy(grid.GetCellTypesArray())) == {vtk.VTK_TETRA}
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    return (
        vtk_to_numpy(grid.GetPoints().GetData()),
        corners,
        vtk_to_numpy(grid.GetCellData().GetArray("material")),
    )


def assert_equal(found, expected):
    for a, b in zip(found, expected):
        assert numpy.array_equal(a, b)


def canonical(grid):
    """The arrays of a grid of pieces, in the order of the numbers in the whole mesh, without ghosts."""
    points, corners, material = arrays(grid)
    data = grid.GetPointData()
    assert data.GetGlobalIds().GetName() == "GlobalPointIds"
    numbers = vtk_to_numpy(data.GetGlobalIds())
    whole = numpy.full((numbers.max() + 1, 3), numpy.nan)
    whole[numbers] = points
    assert not numpy.isnan(whole).any() and numpy.array_equal(whole[numbers], points)
    ghosts = grid.GetCellData().GetArray("vtkGhostType")
    own = vtk_to_numpy(ghosts) == 0 if ghosts else slice(None)
    return whole, numbers[corners][own], material[own]


def check_owners(grid, ranks):
    """Each point has one owner, which all pieces name, and owners follow the numbers."""
    numbers = vtk_to_numpy(grid.GetPointData().GetGlobalIds())
    owners = vtk_to_numpy(grid.GetPointData().GetArray("owner"))
    whole = numpy.full(numbers.max() + 1, -1)
    whole[numbers] = owners
    assert numpy.array_equal(whole[numbers], owners)
    assert (numpy.diff(whole) >= 0).all() and whole[0] == 0 and whole[-1] == ranks - 1


expected = arrays(read(vtk.vtkXMLUnstructuredGridReader(), folder / "1.vtu"))
assert len(expected[1]) > 1000
for suffix in (".vtkhdf", "g.vtkhdf", "one.hdf"):
    sums = {hashlib.sha256((folder / f"{ranks}{suffix}").read_bytes()).hexdigest() for ranks in RANKS}
    assert len(sums) == 1, f"{suffix}: {sums}"
    print(suffix, sums.pop())
assert (folder / "1.vtkhdf").read_bytes() == (folder / "1g.vtkhdf").read_bytes()
assert_equal(arrays(read(vtk.vtkHDFReader(), folder / "8.vtkhdf")), expected)
one = arrays(read(vtk.vtkHDFReader(), folder / "8one.hdf"))
for ranks in RANKS:
    for suffix in (".pvtu", "g.pvtu"):
        grid = read(vtk.vtkXMLPUnstructuredGridReader(), folder / f"{ranks}{suffix}")
        assert_equal(canonical(grid), expected)
        check_owners(grid, ranks)
    assert_equal(canonical(read(vtk.vtkXMLPUnstructuredGridReader(), folder / f"{ranks}one.pvtu")), one)
    assert len(list(folder.glob(f"{ranks}_*.vtu"))) == ranks
print("all alike")
