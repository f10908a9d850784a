"""Lists of pieces in VTK XML are read as one mesh: check_pvtu.py WRITE_SAMPLE DUMP_MESH."""
import pathlib
import subprocess
import sys

import numpy as np
import vtk

from sample import run_checks, same

# Two tetrahedra with a common face, one in each piece.
POINTS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], float)
NUMBERS = [[10, 30, 20, 40], [40, 30, 20, 50]]
PLACES = {10: 0, 30: 1, 20: 2, 40: 3, 50: 4}


def read(path, folder):
    """What the library says, or the arrays that it reads."""
    run = subprocess.run([sys.argv[2], path, folder], stderr=subprocess.PIPE, text=True)
    if run.returncode:
        assert run.returncode == 1 and run.stderr.count("\n") == 1, (run.returncode, run.stderr)
        return run.stderr.strip()
    return (
        np.fromfile(folder + "/points.f64").reshape(-1, 3),
        np.fromfile(folder + "/tets.i32", "<i4").reshape(-1, 4),
        np.fromfile(folder + "/labels.i32", "<i4"),
    )


def array(name, values, kind="Int64"):
    text = " ".join(map(str, np.asarray(values).ravel().tolist()))
    components = 3 if kind == "Float64" else 1
    return f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="ascii">{text}</DataArray>'


def piece(points, tets, cell_arrays, numbers=None):
    tets = np.asarray(tets).reshape(-1, 4)
    data = "" if numbers is None else array("GlobalPointIds", numbers)
    return (
        '<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian"><UnstructuredGrid>'
        f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(tets)}">'
        f'<Points>{array("Points", points, "Float64")}</Points><PointData>{data}</PointData>'
        f'<Cells>{array("connectivity", tets)}{array("offsets", 4 * np.arange(1, len(tets) + 1))}'
        f'{array("types", np.full(len(tets), 10), "UInt8")}</Cells>'
        f'<CellData>{"".join(array(name, values, "Int32") for name, values in cell_arrays.items())}</CellData>'
        "</Piece></UnstructuredGrid></VTKFile>"
    )


def listed(*names, kind="PUnstructuredGrid"):
    pieces = "".join(f'<Piece Source="{name}"/>' for name in names)
    return f'<VTKFile type="{kind}" version="1.0"><{kind} GhostLevel="0">{pieces}</{kind}></VTKFile>'


def write(sample, pieces, names=None, **options):
    """The list of texts of pieces, which lie in a folder of their own."""
    folder = pathlib.Path(sample.path("pieces"))
    folder.mkdir(exist_ok=True)
    for i, text in enumerate(pieces):
        (folder / f"{i}.vtu").write_text(text)
    path = pathlib.Path(sample.path("list.pvtu"))
    path.write_text(listed(*(names or [f"pieces/{i}.vtu" for i in range(len(pieces))]), **options))
    return str(path)


def piece_of(numbers, arrays, with_numbers=True):
    points = POINTS[[PLACES[n] for n in numbers]]
    return piece(points, np.arange(len(numbers)), arrays, numbers if with_numbers else None)


def check_joined(sample):
    for with_numbers in (True, False):
        texts = [piece_of(own, {"material": [3 + i]}, with_numbers) for i, own in enumerate(NUMBERS)]
        texts.insert(1, piece([], [], {"material": []}, [] if with_numbers else None))
        points, tets, labels = read(write(sample, texts), sample.folder)
        same(labels.tolist(), [3, 4], "labels")
        same(len(points), 5, "the number of points")
        wanted = POINTS[[[PLACES[n] for n in own] for own in NUMBERS]]
        same(points[tets].tolist(), wanted.tolist(), "the corners")
        if with_numbers:  # points come in the order of their numbers
            same(points.tolist(), POINTS[[0, 2, 1, 3, 4]].tolist(), "the points")


def check_ghosts(sample):
    both = piece(
        POINTS, [[0, 1, 2, 3], [3, 1, 2, 4]], {"vtkGhostType": [0, 1], "material": [3, 4]}, [10, 30, 20, 40, 50]
    )
    other = piece_of(NUMBERS[1], {"vtkGhostType": [0], "material": [4]})
    points, tets, labels = read(write(sample, [both, other]), sample.folder)
    same((len(points), labels.tolist()), (5, [3, 4]), "points and labels beside ghosts")


def check_cracks(sample):
    """Points at one place with different numbers stay apart."""
    other = piece(POINTS[[3, 1, 2, 4]], [0, 1, 2, 3], {"material": [4]}, [60, 70, 80, 50])
    points = read(write(sample, [piece_of(NUMBERS[0], {"material": [3]}), other]), sample.folder)[0]
    same(len(points), 8, "the number of points of a mesh with a crack")


def check_labels(sample):
    """Arrays that a piece lacks are no labels."""
    for first, second, labels in (
        ({"a": [1], "b": [2]}, {"b": [5]}, [2, 5]),
        ({"a": [1]}, {"b": [5]}, [0, 0]),
        ({"b": [2], "material": [7]}, {"material": [8], "b": [9]}, [7, 8]),
    ):
        path = write(sample, [piece_of(NUMBERS[0], first), piece_of(NUMBERS[1], second)])
        same(read(path, sample.folder)[2].tolist(), labels, "labels")


def check_files_of_vtk(sample):
    """As VTK divides a mesh and writes it, with ghosts and without numbers of points."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(sample.path("vtu.vtu"))
    divide = vtk.vtkExtractUnstructuredGridPiece()
    divide.SetInputConnection(reader.GetOutputPort())
    writer = vtk.vtkXMLPUnstructuredGridWriter()
    writer.SetInputConnection(divide.GetOutputPort())
    path = sample.path("divided.pvtu")
    writer.SetFileName(path)
    writer.SetNumberOfPieces(3)
    writer.SetStartPiece(0)
    writer.SetEndPiece(2)
    writer.SetGhostLevel(1)
    writer.Write()
    points, tets, labels = read(path, sample.folder)
    same(len(points), len(sample.points), "the number of points")
    # The filter makes single numbers of the coordinates.
    rows = lambda x, t, l: sorted(map(repr, np.column_stack([x.astype("f4")[t].reshape(len(t), 12), l]).tolist()))
    same(rows(points, tets, labels), rows(sample.points, sample.tets, sample.labels), "tetrahedra of VTK's pieces")


def check_refused(sample):
    good = [piece_of(own, {"material": [3]}) for own in NUMBERS]
    moved = piece(POINTS[[3, 1, 2, 4]] + 0.5, [0, 1, 2, 3], {"material": [4]}, NUMBERS[1])
    beyond = piece(POINTS[:4], [0, 1, 2, 4], {"material": [3]}, [1, 2, 3, 4])
    bare = piece_of(NUMBERS[1], {"other": [4]})
    for pieces, options, sentence in (
        (good, {"names": ["pieces/0.vtu", "pieces/none.vtu"]}, "pieces/none.vtu': No such file"),
        (good, {"names": ["pieces/0.vtu"] * 2}, "two pieces are the same file, 'pieces/0.vtu'"),
        (good, {"names": ["/dev/zero"]}, "'/dev/zero' is a piece, and must be a regular file"),
        (good, {"names": ["pieces"]}, "pieces' is a piece, and must be a regular file"),
        (good, {"names": [""]}, "the 1st piece names no file"),
        (good, {"kind": "PPolyData"}, "only a PUnstructuredGrid is a list of pieces with tetrahedra"),
        ([good[0], "no piece"], {}, "pieces/1.vtu': this is no VTK file with a piece"),
        ([good[0], moved], {}, "pieces have point 20 of the mesh at different places"),
        ([good[0], beyond], {}, "a piece names point 4 of the 4 that are counted from 0"),
        ([good[0], bare], {}, "the array 'material' is missing in a piece"),
        ([piece([], [], {"material": []}, [])], {}, "there are no tetrahedra in it"),
    ):
        said = read(write(sample, pieces, **options), sample.folder)
        assert isinstance(said, str) and sentence in said, (sentence, said)
    path = sample.path("list.pvtu")
    for text in ("", "no list", listed()):
        pathlib.Path(path).write_text(text)
        assert "this is no VTK file with a list of pieces" in read(path, sample.folder)


if __name__ == "__main__":
    run_checks(
        check_joined,
        check_ghosts,
        check_cracks,
        check_labels,
        check_files_of_vtk,
        check_refused,
    )
