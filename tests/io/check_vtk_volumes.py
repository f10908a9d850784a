"""Volumes of legacy VTK, by VTK and by hand: places, the arrays that are read and passed over, and what is refused.
check_vtk_volumes.py DUMP_VOLUME"""
import numpy as np
import vtk
from vtk.util import numpy_support

from volume_reading import *

UNSUPPORTED, TOO_LARGE = -10, -7
SHAPE = (4, 3, 5)
VOXELS = random_labels(SHAPE, "u1", (0, 1, 2, 9))


def save(writer, grid, name, binary):
    writer.SetInputData(grid)
    writer.SetFileName(path(name))
    writer.SetFileTypeToBinary() if binary else writer.SetFileTypeToASCII()
    writer.Write()


def vtk_image(arrays, on_cells, binary, name, kind="image", scalars=None):
    grid = vtk.vtkImageData() if kind == "image" else vtk.vtkRectilinearGrid()
    points = [n + on_cells for n in SHAPE]
    grid.SetDimensions(*points)
    if kind == "image":
        grid.SetOrigin(10, 20, 30)
        grid.SetSpacing(0.5, 2, 3)
    else:
        for axis, (start, step) in enumerate(((10, 0.5), (20, 2), (30, 3))):
            places = start + step * np.arange(points[axis], dtype=float)
            getattr(grid, "Set%sCoordinates" % "XYZ"[axis])(numpy_support.numpy_to_vtk(places, deep=True))
    where = grid.GetCellData() if on_cells else grid.GetPointData()
    for array_name, values in arrays.items():
        array = numpy_support.numpy_to_vtk(values.ravel(order="F"), deep=True)
        array.SetName(array_name)
        where.AddArray(array)
    if scalars:
        where.SetActiveScalars(scalars)
    save(vtk.vtkStructuredPointsWriter() if kind == "image" else vtk.vtkRectilinearGridWriter(), grid, name, binary)
    return path(name)


def test_vtk():
    for kind in "image", "rectilinear":
        for on_cells in 0, 1:
            affine = np.column_stack(
                [np.diag([0.5, 2, 3]), np.array([10, 20, 30]) + on_cells * np.array([0.25, 1, 1.5])]
            )
            for binary in 0, 1:
                for scalars in None, "labels":  # without, VTK writes a FIELD
                    for dtype in "u1", "i2", "i4", "f4", "i8":
                        name = vtk_image(
                            {"labels": VOXELS.astype(dtype)}, on_cells, binary, "v.vtk", kind=kind, scalars=scalars
                        )
                        check(VOXELS, affine, name)
    other = {"density": np.random.default_rng(1).random(SHAPE), "FeatureIds": VOXELS.astype("i4")}
    name = vtk_image(other, 1, 1, "two.vtk")
    check(VOXELS, np.column_stack([np.diag([0.5, 2, 3]), [10.25, 21, 31.5]]), name)
    warned("of which 'FeatureIds' is read", name)
    refused(FORMAT, "'a' on points, 'b' on points", vtk_image({"a": VOXELS, "b": VOXELS}, 0, 1, "ab.vtk"))
    vectors = vtk_image({"labels": VOXELS.astype("i2")}, 0, 0, "vec.vtk", scalars="labels")
    text = open(vectors).read().replace("labels short", "labels short 3")
    refused(FORMAT, "missing", write("vec.vtk", text))


def test_vtk_numbers_of_points():
    """Ids are no labels, and coordinates are of any type."""
    for binary in 0, 1:
        for dtype in "i1", "u2", "i4", "i8", "f4":
            grid = vtk.vtkRectilinearGrid()
            grid.SetDimensions(*SHAPE)
            for axis, count in enumerate(SHAPE):
                places = (7 + 2 * np.arange(count)).astype(dtype)
                getattr(grid, "Set%sCoordinates" % "XYZ"[axis])(numpy_support.numpy_to_vtk(places, deep=True))
            array = numpy_support.numpy_to_vtk(VOXELS.ravel(order="F"), deep=True)
            array.SetName("parts")
            grid.GetPointData().SetScalars(array)
            ids = numpy_support.numpy_to_vtkIdTypeArray(np.arange(VOXELS.size), deep=True)
            ids.SetName("ids")
            grid.GetPointData().SetGlobalIds(ids)
            save(vtk.vtkRectilinearGridWriter(), grid, "n.vtk", binary)
            check(VOXELS, np.column_stack([2 * np.eye(3), [7, 7, 7]]), path("n.vtk"))
            warned("of which 'parts' is read", path("n.vtk"))


def vtk_text(geometry, data):
    return "# vtk DataFile Version 2.0\ntitle\nASCII\n" + geometry + data


def test_vtk_by_hand():
    values = " ".join(map(str, VOXELS.ravel(order="F")))
    points = "POINT_DATA 60\nSCALARS anything int\nLOOKUP_TABLE default\n" + values
    grid = "DATASET STRUCTURED_POINTS\nDIMENSIONS 4 3 5\nORIGIN 1 2 3\nASPECT_RATIO 1 2 -3\n"
    check(VOXELS, np.array([[1, 0, 0, 1], [0, 2, 0, 2], [0, 0, -3, 3.0]]), write("h.vtk", vtk_text(grid, points)))
    table = "LOOKUP_TABLE mine 2\n0 0 0 1\n1 1 1 1\n"
    check(
        VOXELS,
        np.array([[1, 0, 0, 1], [0, 2, 0, 2], [0, 0, -3, 3.0]]),
        write("h.vtk", vtk_text(grid, points.replace("default", "mine") + "\n" + table)),
    )
    check(
        VOXELS,
        np.array([[1, 0, 0, 1], [0, 2, 0, 2], [0, 0, -3, 3.0]]),
        write(
            "h.vtk",
            vtk_text(
                "FIELD FieldData 1\nTIME 1 1 double\n0.5\n" + grid,
                points.replace("LOOKUP_TABLE default\n", "") + "\nMETADATA\nINFORMATION 0\n\n",
            ),
        ),
    )
    refused(FORMAT, "more values", write("h.vtk", vtk_text(grid, points + " 5")))
    refused(FORMAT, "1 value is missing", write("h.vtk", vtk_text(grid, points.rsplit(" ", 1)[0])))
    refused(FORMAT, "POINT_DATA are 61", write("h.vtk", vtk_text(grid, points.replace("60", "61"))))
    refused(
        FORMAT,
        "its arrays ('v' on points) are colours, vectors, texts or ids; one number a voxel",
        write("h.vtk", vtk_text(grid, "POINT_DATA 60\nVECTORS v int\n" + " ".join(["1"] * 180))),
    )
    refused(FORMAT, "no values", write("h.vtk", vtk_text(grid, "")))
    refused(UNSUPPORTED, "STRUCTURED_GRID", write("h.vtk", vtk_text("DATASET STRUCTURED_GRID\nDIMENSIONS 4 3 5\n", "")))
    refused(UNSUPPORTED, "UNSTRUCTURED_GRID", write("h.vtk", vtk_text("DATASET UNSTRUCTURED_GRID\n", "")))
    uneven = (
        "DATASET RECTILINEAR_GRID\nDIMENSIONS 4 3 5\nX_COORDINATES 4 float\n0 1 2 4\nY_COORDINATES 3 float\n0 1 2\n"
        "Z_COORDINATES 5 float\n0 1 2 3 4\n"
    )
    refused(UNSUPPORTED, "X_COORDINATES", write("h.vtk", vtk_text(uneven, points)))
    bits = np.packbits(VOXELS.ravel(order="F") > 0).tobytes()
    head = vtk_text(grid.replace("-3", "3"), "POINT_DATA 60\nSCALARS on bit\nLOOKUP_TABLE default\n")
    check(
        (VOXELS > 0).astype(int),
        np.array([[1, 0, 0, 1], [0, 2, 0, 2], [0, 0, 3, 3.0]]),
        write("h.vtk", head.replace("ASCII", "BINARY"), bits),
    )


def texts_of(voxel):
    return {0: "", 1: "two words", 2: "x" * 100, 3: "METADATA", 4: "y" * 20000}.get(voxel, "a line\nLOOKUP_TABLE t 3")


def test_vtk_arrays_that_are_passed_over():
    """Texts of all lengths that VTK knows, and texture coordinates, stand in front of the labels."""
    for binary in 0, 1:
        for texts_on_cells in 0, 1:
            grid = vtk.vtkImageData()
            grid.SetDimensions(*SHAPE)
            texts, count = vtk.vtkStringArray(), grid.GetNumberOfCells() if texts_on_cells else VOXELS.size
            texts.SetName("texts")
            for voxel in range(count):
                texts.InsertNextValue(texts_of(voxel))
            coordinates = numpy_support.numpy_to_vtk(np.ones((VOXELS.size, 2), "f4"), deep=True)
            coordinates.SetName("places")
            labels = numpy_support.numpy_to_vtk(VOXELS.astype("i2").ravel(order="F"), deep=True)
            labels.SetName("labels")
            labels.SetComponentName(0, "part")  # in METADATA behind it
            about = vtk.vtkStringArray()
            about.SetName("about")
            about.InsertNextValue("of the file")
            pairs = numpy_support.numpy_to_vtk(np.arange(6.0).reshape(3, 2), deep=True)
            pairs.SetName("pairs")
            pairs.SetComponentName(1, "in METADATA")
            for where, array in (
                (grid.GetCellData() if texts_on_cells else grid.GetPointData(), texts),
                (grid.GetPointData(), labels),
                (grid.GetFieldData(), about),
                (grid.GetFieldData(), pairs),
                (grid.GetFieldData(), labels),
            ):
                where.AddArray(array)
            grid.GetPointData().SetTCoords(coordinates)
            save(vtk.vtkStructuredPointsWriter(), grid, "p.vtk", binary)
            check(VOXELS, np.eye(3, 4), path("p.vtk"))
            warned("'texts' on %s" % ("cells" if texts_on_cells else "points"), path("p.vtk"))
            warned("'places' on points", path("p.vtk"))
            warned("of which 'labels' is read", path("p.vtk"))


def read_by_vtk(name):
    reader = vtk.vtkStructuredPointsReader()
    reader.SetFileName(name)
    reader.Update()
    array = reader.GetOutput().GetPointData().GetArray("labels")
    return numpy_support.vtk_to_numpy(array).reshape(SHAPE, order="F")


def in_field(arrays, coding="BINARY"):
    """A file of these arrays on points, each the line of its head and its values."""
    head = "# vtk DataFile Version 4.2\ntitle\n%s\nDATASET STRUCTURED_POINTS\nDIMENSIONS 4 3 5\n" % coding
    head += "ORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 60\nFIELD FieldData %d\n" % len(arrays)
    return write("f.vtk", head, *[part for array in arrays for part in (*array, "\n")])


LABELS_HERE = ("labels 1 60 unsigned_char\n", VOXELS.tobytes(order="F"))


def test_vtk_lengths_of_texts():
    """In 1, 2, 4 or 8 bytes; VTK reads the same."""
    lengths = [b"\xc3", b"\x80\x03", b"\x40\0\0\3", bytes(7) + b"\3"]
    name = in_field([("texts 1 60 string\n", b"".join(lengths[i % 4] + b"abc" for i in range(60))), LABELS_HERE])
    assert (read_by_vtk(name) == VOXELS).all()
    check(VOXELS, np.eye(3, 4), name)
    long = [b"\xbf\xff" + bytes(0x3FFF), b"\x80\x40" + bytes(0x40)] + [b"\xc0"] * 58
    name = in_field([("texts 1 60 string\n", b"".join(long)), LABELS_HERE])
    assert (read_by_vtk(name) == VOXELS).all()
    check(VOXELS, np.eye(3, 4), name)
    past_the_end = [b"\xc0"] * 59 + [b"\x7f\xff\xff\xff"]
    refused(FORMAT, "missing", in_field([LABELS_HERE, ("texts 1 60 string\n", b"".join(past_the_end))]))
    refused(FORMAT, "missing", in_field([LABELS_HERE, ("texts 1 60 string\n", bytes(7) + b"\3abc")]))
    lines = in_field([("labels 1 60 int\n", "1 " * 60), ("texts 1 60 string\n", "a\n" * 58)], "ASCII")
    refused(FORMAT, "it ends within an array of texts", lines)
    only = in_field([("texts 1 60 string\n", b"\xc0" * 60)])
    refused(FORMAT, "its arrays ('texts' on points) are colours, vectors, texts or ids", only)


def test_vtk_arrays_of_another_form():
    short = ("other 1 59 unsigned_char\n", bytes(59))
    refused(FORMAT, "its array 'other' has 59 values, but 60 are wanted", in_field([LABELS_HERE, short]))
    refused(TOO_LARGE, "too many values", in_field([("many %d 60 int\n" % 2**62, b"")]))
    refused(FORMAT, "'half_precision' cannot be read", in_field([("h 1 60 half_precision\n", bytes(120))]))
    refused(FORMAT, "more on a line of it", in_field([("labels 1 60 unsigned_char 5\n", LABELS_HERE[1])]))
    cut = open(in_field([LABELS_HERE]), "rb").read().replace(b"FieldData 1", b"FieldData 2")
    refused(FORMAT, "it ends where an array of FIELD is wanted", write("f.vtk", cut))
    grid = "DATASET STRUCTURED_POINTS\nDIMENSIONS 4 3 5\n"
    refused(FORMAT, "'POINT_DATA' is '-60'", write("n.vtk", vtk_text(grid, "POINT_DATA -60\n")))
    for components in 0, 65:
        scalars = "POINT_DATA 60\nSCALARS labels int %d\n" % components
        refused(FORMAT, "'SCALARS' is '%d'" % components, write("n.vtk", vtk_text(grid, scalars)))
    for kind in "string", "bit":
        places = "DATASET RECTILINEAR_GRID\nDIMENSIONS 4 3 5\nX_COORDINATES 4 %s\n1 1 0 0\n" % kind
        refused(FORMAT, "its coordinates are of the type '%s'" % kind, write("n.vtk", vtk_text(places, "")))


run_tests(globals())
