"""NRRD, segmentations of 3D Slicer and MetaImage as people have them: places, layouts of files, what is reported and
what is refused. check_text_headers.py DUMP_VOLUME"""
import gzip
import os
import struct
import zlib

import numpy as np

from volume_reading import *

UNSUPPORTED = -10
SHAPE = (4, 3, 5)
VOXELS = random_labels(SHAPE, "u1", (0, 1, 2, 9))
DATA = VOXELS.tobytes(order="F")


def nrrd(name, fields, data=DATA, sizes=SHAPE, encoding="raw", kind="uchar"):
    return write(
        name,
        "NRRD0005\ntype: %s\ndimension: %d\nsizes: %s\nencoding: %s\n%s\n"
        % (kind, len(sizes), " ".join(map(str, sizes)), encoding, fields),
        data,
    )


def test_nrrd_spaces():
    steps = np.array([[0.0, 0.5, 0.1], [-0.6, 0.0, 0.0], [0.0, 0.2, 2.0]])  # sheared
    text = "space directions: (0,0.5,0.1) (-0.6,0,0) (0,0.2,2)\nspace origin: (10,-20,30.5)\n"
    spaces = {
        "left-posterior-superior": (1, 1),
        "LPS": (1, 1),
        "right-anterior-superior": (-1, -1),
        "RAS": (-1, -1),
        "left-anterior-superior": (1, -1),
        "LAS": (1, -1),
        "scanner-xyz": (1, 1),
        "3D-right-handed": (1, 1),
    }
    for space, (x, y) in spaces.items():
        affine = np.diag([x, y, 1]) @ np.column_stack([steps.T, [10, -20, 30.5]])
        name = nrrd("space.nrrd", "space: %s\n%s" % (space, text))
        check(VOXELS, affine, name)
        reads_quietly(name)
    name = nrrd("space.nrrd", "space dimension: 3\n" + text)
    check(VOXELS, np.column_stack([steps.T, [10, -20, 30.5]]), name)
    warned("3d-left-handed", nrrd("space.nrrd", "space: 3D-left-handed\n" + text))
    refused(
        FORMAT,
        "'space' is 'right-anterior-superior-time'",
        nrrd("s.nrrd", "space: right-anterior-superior-time\n" + text),
    )


def test_nrrd_axes():
    affine = lambda spacing, origin: np.column_stack([np.diag(spacing), origin])
    check(VOXELS, affine([0.5, 2, 3], [0, 0, 0]), nrrd("a.nrrd", "spacings: 0.5 2 3\n"))
    flipped = nrrd("a.nrrd", "spacings: -0.5 2 3\n")
    check(VOXELS, affine([-0.5, 2, 3], [0, 0, 0]), flipped)
    check(VOXELS, affine([-4, 2, 3], [0, 0, 0]), flipped, spacing=(4, 0, 0))
    ends = "axis mins: 10 20 30\naxis maxs: 18 26 35\n"  # 4, 3 and 5 voxels from side to side
    check(VOXELS, affine([2, 2, 1], [11, 21, 30.5]), nrrd("a.nrrd", ends + "centers: cell cell cell\n"))
    ends = "axis mins: 10 20 30\naxis maxs: 16 24 34\n"  # from centre to centre
    check(VOXELS, affine([2, 2, 1], [10, 20, 30]), nrrd("a.nrrd", ends + "centerings: node node node\n"))
    warned("taken for sides", nrrd("a.nrrd", "axis mins: 0 0 0\naxis maxs: 4 3 5\n"))
    refused(FORMAT, "along the 1st axis is", nrrd("a.nrrd", "spacings: 1 1 1\naxis mins: 0 0 0\naxis maxs: 9 3 5\n"))
    refused(
        FORMAT,
        "both a spacing and a direction",
        nrrd("a.nrrd", "spacings: 1 1 1\nspace: LPS\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"),
    )
    plane = VOXELS[:, :, :1]
    in_space = nrrd(
        "p.nrrd",
        "space: LPS\nspace directions: (0,0,0.5) (0,2,0)\nspace origin: (1,2,3)\n",
        plane.tobytes(order="F"),
        SHAPE[:2],
    )
    check(plane, np.array([[0, 0, -0.5, 1], [0, 2, 0, 2], [0.5, 0, 0, 3.0]]), in_space)


def test_nrrd_lists():
    ones = np.zeros((2,) + SHAPE, "u1")
    ones[0], ones[1] = VOXELS < 2, VOXELS >= 2
    directions = "(1,0,0) (0,1,0) (0,0,1)"
    first = nrrd(
        "l.nrrd",
        "space: LPS\nspace directions: none %s\nkinds: list domain domain domain\n" % directions,
        ones.tobytes(order="F"),
        (2,) + SHAPE,
    )
    last = nrrd(
        "m.nrrd",
        "space: LPS\nspace directions: %s none\nkinds: domain domain domain list\n" % directions,
        np.moveaxis(ones, 0, 3).tobytes(order="F"),
        SHAPE + (2,),
    )
    for name in first, last:
        check(ones[1].astype(int), np.eye(3, 4), name, kind=INDICATORS)
    for kind, count in (("vector", 2), ("RGB-color", 3), ("3D-symmetric-matrix", 6)):
        name = nrrd("v.nrrd", "kinds: %s domain domain domain\n" % kind, bytes(count * 60), (count,) + SHAPE)
        refused(FORMAT, "%d numbers a voxel" % count, name)
    one = nrrd("o.nrrd", "kinds: list domain domain domain\n", DATA, (1,) + SHAPE)
    check(VOXELS, np.eye(3, 4), one)


def test_nrrd_data_files():
    with_crlf = write(
        "crlf.nrrd",
        "NRRD0001\r\n# comment\r\ntype: uchar\r\ndimension: 3\r\nsizes: 4 3 5\r\n"
        "a key:=a value: of it\r\nencoding: raw\r\n\r\n",
        DATA,
    )
    check(VOXELS, np.eye(3, 4), with_crlf)
    check(VOXELS, np.eye(3, 4), write("bom.nrrd", b"\xef\xbb\xbf", open(with_crlf, "rb").read()))
    os.makedirs(path("sub"), exist_ok=True)
    write("sub/v.raw", "one line\nanother\nskip", DATA)
    skips = "line skip: 2\nbyte skip: 4\ndata file: sub/v.raw\n"
    check(VOXELS, np.eye(3, 4), nrrd("d.nhdr", skips, b""))
    check(VOXELS, np.eye(3, 4), nrrd("d.nhdr", "byte skip: -1\ndatafile: sub/v.raw\n", b""))
    write("sub/v.gz", gzip.compress(b"skip" + DATA))
    check(VOXELS, np.eye(3, 4), nrrd("d.nhdr", "byte skip: 4\ndata file: sub/v.gz\n", b"", encoding="gzip"))
    refused(FORMAT, "'byte skip' is '-1'", nrrd("d.nhdr", "byte skip: -1\ndata file: sub/v.gz\n", b"", encoding="gzip"))
    for k in range(5):
        write("s%02d.raw" % (2 * k), VOXELS[:, :, k].tobytes(order="F"))
    check(VOXELS, np.eye(3, 4), nrrd("d.nhdr", "data file: s%02d.raw 0 8 2\n", b""))
    check(VOXELS, np.eye(3, 4), nrrd("d.nhdr", "data file: s%02d.raw 0 8 2 2\n", b""))
    names = "\n".join("s%02d.raw" % k for k in range(0, 10, 2))
    check(VOXELS, np.eye(3, 4), nrrd("d.nhdr", "data file: LIST\n" + names, b""))
    check(VOXELS[:, :, ::-1], np.eye(3, 4), nrrd("d.nhdr", "data file: LIST 2\n" + "\n".join(names.split()[::-1]), b""))
    check(VOXELS, np.eye(3, 4), nrrd("d.nhdr", "data file: LIST 3\n" + names, b""))
    refused(FORMAT, "data files", nrrd("d.nhdr", "data file: LIST\n" + names[:24], b""))
    refused(FILE, "gone.raw", nrrd("d.nhdr", "data file: gone.raw\n", b""))
    refused(FILE, "it is a folder, not a file", nrrd("d.nhdr", "data file: sub\n", b""))
    os.mkfifo(path("pipe.raw"))
    refused(FILE, "it is a device or pipe, not a file", nrrd("d.nhdr", "data file: pipe.raw\n", b""))
    refused(
        FORMAT, "cut short", write("cut.nhdr", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 4 3 5\nencoding: raw\n")
    )


def test_nrrd_surplus():
    warned("7 bytes behind its voxels", nrrd("more.nrrd", "", DATA + b"surplus"))
    warned("7 bytes behind its voxels", nrrd("more.nrrd", "", gzip.compress(DATA + b"surplus"), encoding="gzip"))
    warned("9 bytes behind its compressed data", nrrd("more.nrrd", "", gzip.compress(DATA) + bytes(9), encoding="gzip"))
    refused(FORMAT, "twice as many", nrrd("more.nrrd", "", DATA + DATA))
    refused(FORMAT, "cannot hold", nrrd("claim.nrrd", "", gzip.compress(DATA), (2048, 2048, 512), "gzip"))
    lines = "".join("key %d:=value\n" % k for k in range(200000))
    check(VOXELS, np.eye(3, 4), nrrd("long.nrrd", lines))


def segment(number, name, value, layer):
    return "".join(
        "Segment%d_%s:=%s\n" % (number, key, text)
        for key, text in (("ID", "Segment_%d" % number), ("Name", name), ("LabelValue", value), ("Layer", layer))
    )


def test_segmentations():
    space = "space: LPS\nspace directions: %s(1,0,0) (0,1,0) (0,0,1)\nkinds: %sdomain domain domain\n"
    flat = space % ("", "") + segment(0, "Liver", 1, 0) + segment(1, "Tumor", 2, 0) + segment(2, "Stone", 9, 0)
    name = nrrd("one.seg.nrrd", flat)
    check(VOXELS, np.eye(3, 4), name)
    reads_quietly(name)
    name = nrrd("one.seg.nrrd", flat.replace("LabelValue:=2", "LabelValue:=77"))
    check(VOXELS, np.eye(3, 4), name)
    warned("value 2, which is no segment", name)
    layers = np.zeros((2,) + SHAPE, "u1")
    layers[0, :2], layers[1, 1:, :, 2:] = 1, 1
    head = space % ("none ", "list ")
    both = np.where(layers[1] > 0, 2, layers[0]).astype(int)
    again = nrrd(
        "two.seg.nrrd",
        head + segment(0, "Bone", 1, 0) + segment(1, "Ball", 1, 1),
        layers.tobytes(order="F"),
        (2,) + SHAPE,
    )
    check(both, np.eye(3, 4), again)
    warned("1 Bone, 2 Ball", again)
    warned("%d voxels belong to segments of several layers" % (layers.sum(axis=0) == 2).sum(), again)
    layers[1] *= 7
    apart = nrrd(
        "two.seg.nrrd",
        head + segment(0, "Bone", 1, 0) + segment(1, "Ball", 7, 1),
        layers.tobytes(order="F"),
        (2,) + SHAPE,
    )
    check(np.where(layers[1] > 0, 7, layers[0]).astype(int), np.eye(3, 4), apart)
    refused(
        FORMAT,
        "value 7, which is no segment",
        nrrd(
            "two.seg.nrrd",
            head + segment(0, "Bone", 1, 0) + segment(1, "Ball", 5, 1),
            layers.tobytes(order="F"),
            (2,) + SHAPE,
        ),
    )
    refused(
        FORMAT,
        "is in layer 2",
        nrrd("two.seg.nrrd", head + segment(0, "Bone", 1, 2), layers.tobytes(order="F"), (2,) + SHAPE),
    )
    refused(FORMAT, "'Liver' and 'Tumor'", nrrd("same.seg.nrrd", flat.replace("LabelValue:=2", "LabelValue:=1")))
    refused(
        UNSUPPORTED, "fractions", nrrd("f.seg.nrrd", flat + "Segmentation_MasterRepresentation:=Fractional labelmap\n")
    )


def test_layers_of_every_type():
    """Two layers, of which the second is on top: with the least and the greatest labels of the type."""
    head = "space: LPS\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\nkinds: list domain domain domain\n"
    for kind, dtype, low, high in (
        ("uchar", "u1", 1, 255),
        ("signed char", "i1", -128, 127),
        ("unsigned short", "u2", 1, 65535),
        ("short", "i2", -32768, 32767),
        ("unsigned int", "u4", 1, 2**31 - 1),
        ("int", "i4", -(2**31), 2**31 - 1),
    ):
        first = random_labels(SHAPE, "<" + dtype, (0, low), 1)
        second = random_labels(SHAPE, "<" + dtype, (0, high), 2)
        keys = segment(0, "Low", low, 0) + segment(1, "High", high, 1)
        for order, endian in (("<", "little"), (">", "big")):
            layers = np.array([first, second]).astype(order + dtype).tobytes(order="F")
            name = nrrd("t.seg.nrrd", head + "endian: %s\n" % endian + keys, layers, (2,) + SHAPE, kind=kind)
            check(np.where(second != 0, second, first).astype(np.int64), np.eye(3, 4), name)
            run, _ = run_dump([name])
            assert "name: %d Low\n" % low in run.stdout and "name: %d High\n" % high in run.stdout, run.stdout
    keys = segment(0, "One", 1, 0) + segment(1, "Two", 2, 1)
    unknown = np.zeros((2,) + SHAPE, "<u4")
    unknown[1, 0, 0, 0] = 2**32 - 1
    name = nrrd("t.seg.nrrd", head + "endian: little\n" + keys, unknown.tobytes("F"), (2,) + SHAPE, kind="unsigned int")
    refused(FORMAT, "layer 1 has voxels of value 4294967295, which is no segment", name)
    for kind, size, words in (
        ("int64", 8, "whole numbers of up to 32 bits"),
        ("uint64", 8, "whole numbers of up to 32 bits"),
        ("float", 4, "its voxels are no whole numbers"),
        ("double", 8, "its voxels are no whole numbers"),
    ):
        name = nrrd("t.seg.nrrd", head + "endian: little\n" + keys, bytes(2 * 60 * size), (2,) + SHAPE, kind=kind)
        refused(FORMAT, words, name)
    for value in 0, 2**31, -(2**31) - 1:
        name = nrrd("t.seg.nrrd", head + segment(0, "One", value, 0), bytes(2 * 60), (2,) + SHAPE)
        refused(FORMAT, "'Segment0_LabelValue' is '%d'" % value, name)


def meta(name, fields, data=DATA, size="4 3 5", dims=3):
    return write(
        name, "ObjectType = Image\nNDims = %d\n" % dims, fields, "DimSize = %s\nElementType = MET_UCHAR\n" % size, data
    )


def test_metaimage_geometry():
    place = np.array([[0, -2, 0, 1], [0.5, 0, 0, 2], [0, 0, 3, 3.0]])
    for offset in "Offset", "Position", "Origin":
        for matrix in "TransformMatrix", "Rotation", "Orientation":
            for spacing in "ElementSpacing", "ElementSize":
                name = meta(
                    "g.mha",
                    "%s = 1 2 3\n%s = 0 1 0 -1 0 0 0 0 1\n%s = 0.5 2 3\nAnatomicalOrientation = RAI\n"
                    % (offset, matrix, spacing),
                    b"ElementDataFile = LOCAL\n" + DATA,
                )
                check(VOXELS, place, name)
                reads_quietly(name)
    both = meta("both.mha", "ElementSize = 9 9 9\nElementSpacing = 1 2 3\n", b"ElementDataFile = LOCAL\n" + DATA)
    check(VOXELS, np.diag([1.0, 2, 3, 0])[:3], both)
    warned("no ElementSpacing", meta("g.mha", "", b"ElementDataFile = LOCAL\n" + DATA))
    warned("'Sharpness'", meta("g.mha", "Sharpness = 5\n", b"ElementDataFile = LOCAL\n" + DATA))
    plane = meta(
        "p.mha",
        "ElementSpacing = 0.5 2\nTransformMatrix = 0 1 -1 0\n",
        b"ElementDataFile = LOCAL\n" + VOXELS[:, :, 0].tobytes(order="F"),
        "4 3",
        2,
    )
    check(VOXELS[:, :, :1], np.array([[0, -2, 0, 0], [0.5, 0, 0, 0], [0, 0, 0.5, 0.0]]), plane)
    crlf = write("crlf.mha", open(both, "rb").read().replace(DATA, b"").replace(b"\n", b"\r\n"), DATA)
    check(VOXELS, np.diag([1.0, 2, 3, 0])[:3], crlf)


def test_metaimage_data_files():
    spacing = "ElementSpacing = 1 1 1\n"
    write("m.raw", b"head", DATA)
    for header in "4", "-1":
        check(VOXELS, np.eye(3, 4), meta("d.mhd", spacing + "HeaderSize = %s\n" % header, "ElementDataFile = m.raw\n"))
    packed = zlib.compress(DATA)
    write("m.zraw", packed)
    for size in "", "CompressedDataSize = %d\n" % len(packed):
        check(
            VOXELS,
            np.eye(3, 4),
            meta("d.mhd", spacing + "CompressedData = True\n" + size, "ElementDataFile = m.zraw\n"),
        )
    refused(
        FORMAT,
        "missing",
        meta("d.mhd", spacing + "CompressedData = True\nCompressedDataSize = 9999\n", "ElementDataFile = m.zraw\n"),
    )
    for k in range(5):
        write("m%03d.raw" % (k + 1), VOXELS[:, :, k].tobytes(order="F"))
    check(VOXELS, np.eye(3, 4), meta("d.mhd", spacing, "ElementDataFile = m%03d.raw 1 5 1\n"))
    check(VOXELS, np.eye(3, 4), meta("d.mhd", spacing, "ElementDataFile = m%03d.raw\n"))
    names = "".join("m%03d.raw\n" % (k + 1) for k in range(5))
    for how in "LIST", "LIST2D", "LIST 2D":
        check(VOXELS, np.eye(3, 4), meta("d.mhd", spacing, "ElementDataFile = %s\n%s" % (how, names)))
    refused(FORMAT, "5 are wanted", meta("d.mhd", spacing, "ElementDataFile = LIST\n" + names[:18]))
    refused(FILE, "m006.raw", meta("d.mhd", spacing, "ElementDataFile = m%03d.raw 2 6 1\n"))


def test_text_that_may_be_cut():
    """A last number without anything behind it may have lost digits."""
    numbers = " ".join(map(str, VOXELS.ravel(order="F")))
    vtk = (
        "# vtk DataFile Version 2.0\ntitle\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 4 3 5\n"
        "POINT_DATA 60\nSCALARS a int\nLOOKUP_TABLE default\n"
    )
    for make in (
        lambda end: write("t.vtk", vtk, numbers + end),
        lambda end: nrrd("t.nrrd", "", (numbers + end).encode(), encoding="text"),
        lambda end: meta(
            "t.mha", "BinaryData = False\nElementSpacing = 1 1 1\n", "ElementDataFile = LOCAL\n" + numbers + end
        ),
    ):
        check(VOXELS, np.eye(3, 4), make("\n"))
        reads_quietly(make("\n"))
        check(VOXELS, np.eye(3, 4), make(""))
        warned("without an end of the line", make(""))


def test_foreign_formats():
    mgh = struct.pack(">iiii", 1, 4, 3, 5)
    for name, data, words in (
        ("v.mgz", gzip.compress(mgh), "'mri_convert v.mgz v.nii.gz'"),
        ("v.mgh", mgh, "mri_convert"),
        ("PROFILE_STEM.mgh", mgh, "'mri_convert PROFILE_STEM.mgh PROFILE_STEM.nii.gz'"),
        ("v.npy", b"\x93NUMPY\1\0", "--dims"),
        ("v.npz", b"PK\3\4", "NumPy"),
        ("v.vtkhdf", b"\x89HDF\r\n\x1a\n", "'cleft check v.vtkhdf' reads it"),
        ("v.mfem.000000", b"MFEM mesh v1.2\n", "have cleft-mpi write .vtkhdf or .pvtu"),
        ("v.h5", b"\x89HDF\r\n\x1a\n", "h5py"),
        ("v.mnc", b"\x89HDF\r\n\x1a\n", "MINC"),
        ("v.mnc", b"CDF\1", "MINC"),
        ("v.mat", b"MATLAB 5.0 MAT-file", "MATLAB"),
        ("v.czi", b"ZISRAWFILE", "Zeiss"),
        ("v.nd2", b"\xda\xce\xbe\x0a", "Nikon"),
        ("v.lif", b"\x70\0\0\0", "Leica"),
        ("v.am", b"# AmiraMesh 3D", "Amira"),
        ("v.vti", b'<?xml version="1.0"?>\n<VTKFile type="ImageData">', "ParaView"),
        ("v.raw", b"123456", "--dims"),
        ("v.nrrd.gz", gzip.compress(b"NRRD0004\n"), "decompress"),
        ("v.gif", b"GIF89a", "GIF"),
        ("v.webp", b"RIFF0000WEBP", "WebP"),
        ("v.jp2", b"\0\0\0\x0cjP  ", "JPEG 2000"),
        ("v.pgm", b"P5 4 3 255 ", "PGM"),
        ("v.v", b"MATRIX72v", "ECAT"),
        ("v.par", b"# === DATA DESCRIPTION FILE", "parrec2nii"),
        ("v.msh", b"$MeshFormat\n", "'cleft check v.msh'"),
        ("v.stl", b"solid a\n", "surface"),
        ("v.mha.gz", gzip.compress(b"ObjectType = Image\n"), "decompress"),
        ("v.nii.gz", b"version https://git-lfs.github.com/spec/v1\n", "git lfs pull"),
        ("v.nii", b"<!DOCTYPE html><html></html>", "a web page"),
    ):
        refused(UNSUPPORTED, words, write(name, data))
    os.makedirs(path("v.zarr"))
    write("v.zarr/.zgroup", b'{"zarr_format": 2}')
    refused(UNSUPPORTED, "Zarr", path("v.zarr"))


run_tests(globals())
