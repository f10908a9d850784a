"""Volumes written without ITK are read with their voxels in order, their labels and their place in the world:
check_volumes.py DUMP_VOLUME."""
import os
import struct

import nibabel
import numpy as np
from PIL import Image

from volume_reading import *


def write_nrrd(name, voxels, fields="", spacings=True, data=None):
    types = {
        "u1": "uint8",
        "i1": "int8",
        "u2": "uint16",
        "i2": "int16",
        "u4": "uint32",
        "i4": "int32",
        "u8": "uint64",
        "i8": "int64",
        "f4": "float",
        "f8": "double",
    }
    head = "NRRD0004\ntype: %s\ndimension: %d\nsizes: %s\nendian: little\nencoding: raw\n%s\n" % (
        types[voxels.dtype.str[1:]],
        voxels.ndim,
        " ".join(map(str, voxels.shape)),
        fields,
    )
    with open(path(name), "wb") as file:
        file.write(head.encode() + (voxels.tobytes(order="F") if data is None else data))
    return path(name)


def test_nrrd_types():
    identity = np.eye(3, 4)
    for dtype, values in (
        ("u1", (0, 5, 255)),
        ("i1", (-128, 0, 127)),
        ("u2", (0, 300, 65535)),
        ("i2", (-32768, 0, 1)),
        ("u4", (0, 70000, 2**31 - 1)),
        ("i4", (-(2**31) + 1, -5, 2**31 - 1)),
        ("u8", (0, 1, 2**31 - 1)),
        ("i8", (-(2**31) + 1, 3, 2**31 - 1)),
        ("f4", (0, 7, 40)),
        ("f8", (0, 7, 2**31 - 1)),
    ):
        voxels = random_labels((4, 3, 5), "<" + dtype, values)
        check(voxels.astype(np.int64), identity, write_nrrd("types.nrrd", voxels))
    for dtype, value in (("u8", 2**31), ("i8", -(2**31) - 1), ("i8", 2**40)):
        voxels = random_labels((4, 3, 5), "<" + dtype, (0, value))
        refused(FORMAT, "does not fit", write_nrrd("wide.nrrd", voxels))


def test_nrrd_geometry():
    voxels = random_labels((4, 3, 5), "<u1", (1, 2, 9))
    directions = np.array([[0.0, 0.5, 0.1], [-0.6, 0.0, 0.0], [0.0, 0.2, 2.0]])  # rows: steps of the axes; sheared
    text = " ".join("(%r,%r,%r)" % tuple(row) for row in directions.tolist())
    for space, to_lps in (("left-posterior-superior", np.eye(3)), ("right-anterior-superior", FLIP)):
        name = write_nrrd(
            "space.nrrd", voxels, "space: %s\nspace directions: %s\nspace origin: (10,-20,30.5)\n" % (space, text)
        )
        affine = to_lps @ np.column_stack([directions.T, [10, -20, 30.5]])
        check(voxels, affine, name)
        check(voxels, FLIP @ affine, name, world=RAS)
    name = write_nrrd(
        "flat.nrrd",
        voxels,
        "space: left-posterior-superior\n" "space directions: (1,0,0) (0,1,0) (1,1,0)\nspace origin: (0,0,0)\n",
    )
    refused(FORMAT, "lie in a plane", name)
    name = write_nrrd("spacings.nrrd", voxels, "spacings: 0.5 0.25 3\n")
    check(voxels, np.column_stack([np.diag([0.5, 0.25, 3]), np.zeros(3)]), name)
    check(voxels, np.column_stack([np.diag([0.5, 2, 3]), np.zeros(3)]), name, spacing=(0, 2, 0))
    refused(ARGUMENT, "positive", name, spacing=(-1, 0, 0))


def test_nrrd_contents():
    voxels = random_labels((2, 4, 3, 5), "<f4", (0.0, 1.0))
    refused(FORMAT, "numbers a voxel", write_nrrd("vectors.nrrd", voxels, "kinds: vector domain domain domain\n"))
    voxels = random_labels((4, 3, 5), "<f4", (-1.0, 2.0))
    check((voxels > 0).astype(int), np.eye(3, 4), write_nrrd("signed.nrrd", voxels), kind=INDICATORS)
    check(np.round(voxels / 4 + 0.1).astype(int), np.eye(3, 4), write_nrrd("fraction.nrrd", voxels / 4), kind=LABELS)
    voxels[1, 2, 3] = np.nan
    refused(NOT_FINITE, "2nd along x, the 3rd along y and the 4th along z", write_nrrd("nan.nrrd", voxels))
    refused(FORMAT, "237 bytes are missing", write_nrrd("short.nrrd", voxels, data=b"123"))
    refused(FILE, "no such file", path("missing.nrrd"))
    with open(path("text.nrrd"), "w") as file:
        file.write("this is no volume\n")
    refused(FILE, "no format", path("text.nrrd"))
    flat = random_labels((4, 3), "<u1", (1, 2, 9))
    check(flat[:, :, None], np.eye(3, 4), write_nrrd("plane.nrrd", flat))


def test_indicators():
    fields = np.random.default_rng(1).random((3, 6, 5, 4)).astype("<f4")
    winners = fields.argmax(axis=0)
    names = [write_nrrd("f%d.nrrd" % i, np.asfortranarray(field)) for i, field in enumerate(fields)]
    check(winners, np.eye(3, 4), *names)
    names[1] = write_nrrd("double.nrrd", np.asfortranarray(fields[1]).astype("<f8"))
    check(winners, np.eye(3, 4), *names)
    whole = (fields * 250).astype("<u1")
    names = [write_nrrd("w%d.nrrd" % i, np.asfortranarray(field)) for i, field in enumerate(whole)]
    check(whole.argmax(axis=0), np.eye(3, 4), *names, kind=INDICATORS)
    refused(ARGUMENT, "one file", *names, kind=LABELS, named=False)
    affine = np.diag([2.0, 2, 2, 1])
    nibabel.save(nibabel.Nifti1Image(np.moveaxis(fields, 0, 3), affine), path("four.nii.gz"))
    check(winners, affine[:3], path("four.nii.gz"), world=RAS)
    shifted = write_nrrd("shifted.nrrd", np.asfortranarray(whole[1]), "spacings: 1 1 2\n")
    refused(ARGUMENT, "places", names[0], shifted)
    smaller = write_nrrd("smaller.nrrd", np.asfortranarray(whole[1, 1:]))
    refused(ARGUMENT, "5 x 5 x 4", names[0], smaller)


def test_metaimage():
    voxels = random_labels((4, 3, 5), "<u2", (0, 1, 500))
    header = (
        "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = False\n"
        "TransformMatrix = 0 1 0 -1 0 0 0 0 1\nOffset = 1 2 3\nElementSpacing = 0.5 2 %s\nDimSize = 4 3 5\n"
        "ElementType = MET_USHORT\nElementDataFile = %s\n"
    )
    affine = np.array([[0, -2, 0, 1], [0.5, 0, 0, 2], [0, 0, 3, 3.0]])
    with open(path("v.mha"), "wb") as file:
        file.write((header % ("3", "LOCAL")).encode() + voxels.tobytes(order="F"))
    with open(path("v.mhd"), "w") as file:
        file.write(header % ("3", "v.raw"))
    open(path("v.raw"), "wb").write(voxels.tobytes(order="F"))
    check(voxels, affine, path("v.mha"))
    check(voxels, affine, path("v.mhd"))
    with open(path("zero.mha"), "wb") as file:
        file.write((header % ("0", "LOCAL")).encode() + voxels.tobytes(order="F"))
    refused(FORMAT, "spacing", path("zero.mha"))
    affine[2, 2] = 7
    check(voxels, affine, path("zero.mha"), spacing=(0, 0, 7))


def test_pictures():
    voxels = random_labels((6, 4, 12), "u1", (0, 85, 170))
    pages = [Image.fromarray(voxels[:, :, k].T.copy()) for k in range(12)]
    pages[0].save(path("stack.tif"), save_all=True, append_images=pages[1:])
    pages[0].save(path("dpi.tif"), save_all=True, append_images=pages[1:], dpi=(300, 300))
    pages[0].save(path("packed.tiff"), save_all=True, append_images=pages[1:], compression="tiff_lzw")
    for name in ("stack.tif", "dpi.tif", "packed.tiff"):
        check(voxels, np.eye(3, 4), path(name))
    check(voxels, np.diag([0.5, 0.5, 2, 0])[:3], path("stack.tif"), spacing=(0.5, 0.5, 2))
    for k, page in enumerate(pages):
        page.save(path("s%d.png" % k))  # s10 comes after s9
        page.save(path("n%03d.bmp" % (k + 1)))
        page.save(path("t%d.tif" % k))
    check(voxels, np.eye(3, 4), path("s*.png"))
    check(voxels, np.eye(3, 4), path("n%03d.bmp"))
    check(voxels, np.eye(3, 4), path("t?*.tif"))
    check(voxels[:, :, :1], np.eye(3, 4), path("s0.png"))
    palette = Image.fromarray((voxels[:, :, 0] // 85).T.copy(), "P")
    palette.putpalette([255, 0, 0, 0, 255, 0, 0, 0, 255])
    palette.save(path("palette.png"))
    check(voxels[:, :, :1] // 85, np.eye(3, 4), path("palette.png"))
    Image.fromarray(np.zeros((4, 6, 3), "u1")).save(path("colours.png"))
    refused(FORMAT, "numbers a voxel", path("colours.png"))
    refused(FILE, "no file", path("nothing*.png"))
    pages[0].resize((3, 3)).save(path("s3.png"))
    refused(FORMAT, "s3.png", path("s*.png"))


def dicom_element(group, element, vr, value):
    value = value.encode() if isinstance(value, str) else value
    value += b"\0" * (len(value) % 2) if vr in ("UI", "OW") else b" " * (len(value) % 2)
    length = struct.pack("<HI", 0, len(value)) if vr == "OW" else struct.pack("<H", len(value))
    return struct.pack("<HH", group, element) + vr.encode() + length + value


def write_dicom(name, pixels, position, number):
    """One slice, explicit little-endian; pixels as [column, row]."""
    short = lambda value: struct.pack("<H", value)
    kind = "1.2.840.10008.5.1.4.1.1.2"  # computed tomography
    meta = b"".join(
        [
            dicom_element(2, 1, "OB", b"")[:6] + struct.pack("<HI", 0, 2) + b"\0\1",
            dicom_element(2, 2, "UI", kind),
            dicom_element(2, 3, "UI", "1.2.3.%d" % number),
            dicom_element(2, 0x10, "UI", "1.2.840.10008.1.2.1"),
        ]
    )
    columns, rows = pixels.shape
    body = b"".join(
        [
            dicom_element(8, 0x16, "UI", kind),
            dicom_element(8, 0x18, "UI", "1.2.3.%d" % number),
            dicom_element(8, 0x60, "CS", "CT"),
            dicom_element(0x18, 0x50, "DS", "1"),
            dicom_element(0x20, 0xD, "UI", "1.2.4"),
            dicom_element(0x20, 0xE, "UI", "1.2.5"),
            dicom_element(0x20, 0x13, "IS", "%d" % number),
            dicom_element(0x20, 0x32, "DS", "%g\\%g\\%g" % tuple(position)),
            dicom_element(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0"),
            dicom_element(0x28, 2, "US", short(1)),
            dicom_element(0x28, 4, "CS", "MONOCHROME2"),
            dicom_element(0x28, 0x10, "US", short(rows)),
            dicom_element(0x28, 0x11, "US", short(columns)),
            dicom_element(0x28, 0x30, "DS", "0.5\\0.25"),
            dicom_element(0x28, 0x100, "US", short(16)),
            dicom_element(0x28, 0x101, "US", short(16)),
            dicom_element(0x28, 0x102, "US", short(15)),
            dicom_element(0x28, 0x103, "US", short(0)),
            dicom_element(0x7FE0, 0x10, "OW", pixels.astype("<u2").tobytes(order="F")),
        ]
    )
    with open(name, "wb") as file:
        file.write(b"\0" * 128 + b"DICM" + dicom_element(2, 0, "UL", struct.pack("<I", len(meta))) + meta + body)


def test_dicom():
    voxels = random_labels((6, 4, 5), "u2", (0, 3, 900))
    os.mkdir(path("series"))
    slice_path = lambda k: path("series/%d.dcm" % (9 - k))  # names in the other order than places
    for k in range(5):
        write_dicom(slice_path(k), voxels[:, :, k], (10, 20, 30 + 3 * k), k + 1)
    affine = np.array([[0.25, 0, 0, 10], [0, 0.5, 0, 20], [0, 0, 3, 30]])
    check(voxels, affine, path("series"))
    affine[2, 2] = 1  # a single file knows its thickness only
    check(voxels[:, :, :1], affine, slice_path(0))
    os.remove(slice_path(2))
    refused(FORMAT, "evenly spaced", path("series"))
    os.mkdir(path("empty"))
    refused(FILE, "DICOM series", path("empty"))


def test_damaged():
    """Cut and changed files are read or refused, never a crash; what they hold is not our affair."""
    voxels = random_labels((4, 3, 5), "i2", (0, 7))
    nibabel.save(nibabel.Nifti1Image(voxels, np.eye(4)), path("whole.nii"))
    sources = {
        "nii": path("whole.nii"),
        "nrrd": write_nrrd("whole.nrrd", voxels.astype("<i2")),
        "tif": path("stack.tif"),
    }
    random = np.random.default_rng(3)
    for extension, source in sources.items():
        data = open(source, "rb").read()
        for trial in range(25):
            damaged = bytearray(data[: random.integers(len(data))] if trial % 3 == 0 else data)
            for _ in range(trial % 3 * 2):
                damaged[random.integers(min(len(damaged), 400))] = random.integers(256)
            name = path("damaged." + extension)
            open(name, "wb").write(damaged)
            run_dump([name])


run_tests(globals())
