"""Metrics in .vti files that VTK writes in all of its ways; and files that are damaged.

check_vti_tensors.py DUMP_METRIC
"""
import itertools
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk

DIMS = (4, 3, 2)
ORIGIN, SPACING = np.array([5.0, -7.0, 1.0]), np.array([0.5, 2.0, 3.0])
NINE, SIX = (0, 1, 2, 1, 3, 4, 2, 4, 5), (0, 3, 5, 1, 4, 2)  # of xx xy xz yy yz zz


def tensors(count):
    """xx xy xz yy yz zz, another one at each voxel."""
    shift = np.arange(count)[:, None] * np.array([[0.1, 0.001, -0.002, 0.05, 0.003, 0.02]])
    return np.array([[2, 0.1, 0.2, 3, 0.3, 4]]) + shift


def write(path, on_cells, order, kind, change=lambda writer, image: None):
    image = vtk.vtkImageData()
    image.SetExtent(2, 2 + DIMS[0] - 1 + on_cells, 0, DIMS[1] - 1 + on_cells, -1, DIMS[2] - 2 + on_cells)
    image.SetOrigin(ORIGIN)
    image.SetSpacing(SPACING)
    values = tensors(np.prod(DIMS))
    data = image.GetCellData() if on_cells else image.GetPointData()
    array = numpy_to_vtk(np.ascontiguousarray(values[:, order]).astype(kind))
    array.SetName("metric")
    data.AddArray(array)
    labels = numpy_to_vtk(np.arange(len(values)).astype(np.uint8))
    labels.SetName("labels")
    data.AddArray(labels)
    writer = vtk.vtkXMLImageDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    change(writer, image)
    writer.Write()
    return values


def dump(path):
    done = subprocess.run([sys.argv[1], path], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"{path}: ended by {done.returncode}")
    return np.array(done.stdout.split(), float), done.stderr


def check_ways(path):
    modes = ("SetDataModeToAscii", "SetDataModeToBinary", "SetDataModeToAppended")
    for on_cells, order, mode in itertools.product((0, 1), (NINE, SIX), modes):
        for zipped, encoded in itertools.product((0, 1), (0, 1)):
            wide = zipped == encoded
            kind = np.float64 if zipped == on_cells else np.float32

            def change(writer, image):
                getattr(writer, mode)()
                if zipped:
                    writer.SetCompressorTypeToZLib()
                else:
                    writer.SetCompressorTypeToNone()
                writer.SetEncodeAppendedData(encoded)
                (writer.SetHeaderTypeToUInt64 if wide else writer.SetHeaderTypeToUInt32)()

            wanted = write(path, on_cells, order, kind, change)
            found, words = dump(path)
            assert not words, words
            assert tuple(found[:3]) == DIMS, found[:3]
            first = ORIGIN + (np.array([2, 0, -1]) + 0.5 * on_cells) * SPACING
            affine = np.hstack([np.diag(SPACING), first[:, None]])
            assert np.allclose(found[3:15], affine.ravel()), found[3:15]
            assert np.allclose(found[15:].reshape(-1, 6), wanted, rtol=1e-5, atol=1e-6)


def check_refusals(path):
    write(path, 0, NINE, np.float64, lambda writer, image: writer.SetDataModeToAscii())
    whole = path.read_bytes()
    for old, new, words in (
        (b'Extent="2 5 0 2 -1 0">', b'Extent="2 9 0 2 -1 0">', "216 numbers instead of 432"),
        (b'Extent="2 5 0 2 -1 0">', b'Extent="5 2 0 2 -1 0">', "first and a last point"),
        (b'NumberOfComponents="9"', b'NumberOfComponents="8"', "0 arrays of six or nine"),
        (b'byte_order="LittleEndian"', b'byte_order="BigEndian"', "big-endian"),
        (b'Spacing="0.5 2 3"', b'Spacing="0.5 2"', "Spacing"),
        (b'Spacing="0.5 2 3"', b'Spacing="0.5 0 3"', ""),
        (b"</Piece>", b'</Piece><Piece Extent="0 1 0 1 0 1">', "one piece"),
    ):
        assert old in whole, old
        # The extent of the piece is the last one.
        at = whole.rindex(old)
        path.write_bytes(whole[:at] + new + whole[at + len(old) :])
        found, said = dump(path)
        assert not len(found) and said and words in said, (new, said)
    for end in range(0, len(whole) - 20, 97):
        path.write_bytes(whole[:end])
        dump(path)  # some of what is cut short is whole enough; nothing may crash


with tempfile.TemporaryDirectory() as folder:
    check_ways(pathlib.Path(folder) / "metric.vti")
    check_refusals(pathlib.Path(folder) / "metric.vti")
