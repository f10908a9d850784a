"""NIfTI-1, NIfTI-2 and Analyze as nibabel writes them, and with headers changed: read voxel by voxel with the place
that nibabel gives, or refused by what they are. check_nifti.py DUMP_VOLUME"""
import glob
import gzip
import os
import struct
import warnings

import nibabel
import numpy as np

from volume_reading import *

UNSUPPORTED = -10
DTYPES = ("u1", "i1", "u2", "i2", "u4", "i4", "u8", "i8", "f4", "f8")
C, S = np.cos(0.3), np.sin(0.3)
ROTATED = np.array([[C * 0.5, -S * 2, 0, 5], [S * 0.5, C * 2, 0, -7], [0, 0, 3, 11], [0, 0, 0, 1]])
FLIPPED = np.array([[-1.5, 0, 0, 90], [0, 0, 2, -126], [0, 1, 0, -72], [0, 0, 0, 1.0]])
SHEARED = ROTATED + np.array([[0, 0, 1, 0]] + [[0] * 4] * 3)
warnings.simplefilter("ignore")


def labels(dtype="i2", values=(0, 3, 7), shape=(5, 4, 6)):
    return random_labels(shape, dtype, values)


def save(voxels, name="a.nii", kind=nibabel.Nifti1Image, sform=None, qform=None, codes=None, order="<", **fields):
    """Writes the image and returns its path. `codes` are those of sform and qform; `fields` are put into the header."""
    header = kind.header_class(endianness=order)
    header.set_data_dtype(voxels.dtype)
    image = kind(voxels, np.eye(4) if sform is None else sform, header)
    if codes is not None:
        image.set_sform(sform, codes[0])
        image.set_qform(qform, codes[1])
    for field, value in fields.items():
        image.header[field] = value
    image.to_filename(path(name))
    for place in glob.glob(path("*.mat*")):  # nibabel's, of Analyze: not read by Cleft, which says so
        os.remove(place)
    return path(name)


def check_as_nibabel(name, reported=None, **options):
    image = nibabel.load(name)
    voxels = np.asarray(image.dataobj)
    check(voxels, image.affine[:3], name, world=RAS, **options)
    check(voxels, FLIP @ image.affine[:3], name, **options)
    if reported is None:
        reads_quietly(name)
    else:
        warned(reported, name)


def patch(name, offset, kind, *values):
    data = bytearray(open(name, "rb").read())
    struct.pack_into(kind, data, offset, *values)
    open(name, "wb").write(data)
    return name


def write(name, data):
    open(path(name), "wb").write(data)
    return path(name)


def test_types():
    for kind, ending in (
        (nibabel.Nifti1Image, ".nii"),
        (nibabel.Nifti1Pair, ".img"),
        (nibabel.Nifti2Image, ".nii"),
        (nibabel.Nifti2Pair, ".img"),
        (nibabel.Spm2AnalyzeImage, ".img"),
    ):
        analyze = kind is nibabel.Spm2AnalyzeImage
        for dtype in DTYPES:
            if analyze and dtype not in ("u1", "i2", "i4", "f4", "f8"):
                continue
            voxels = labels(dtype, (-5, 0, 7) if dtype[0] == "i" else (0, 3, 7))
            for order, packed in (("<", ".gz"), (">", "")):
                name = save(
                    voxels, "a" + ending + packed, kind, np.diag([-2, 3, 4, 1.0]) if analyze else ROTATED, order=order
                )
                check(
                    np.asarray(nibabel.load(name).dataobj),
                    nibabel.load(name).affine[:3],
                    path("a.hdr" + packed) if dtype == "u1" and ending == ".img" else name,
                    world=RAS,
                )
                for part in (".nii", ".img", ".hdr"):
                    if os.path.exists(path("a" + part + packed)):
                        os.remove(path("a" + part + packed))


def test_forms():
    """The sform if its code is set, else the qform, else the sizes of the voxels: the numbers are those of nibabel."""
    for kind in (nibabel.Nifti1Image, nibabel.Nifti2Image):
        for sform, qform, codes, reported in (
            (ROTATED, ROTATED, (1, 1), None),
            (FLIPPED, FLIPPED, (2, 1), None),
            (FLIPPED, None, (1, 0), None),
            (SHEARED, None, (1, 0), None),
            (None, FLIPPED, (0, 3), None),
            (ROTATED, FLIPPED, (0, 1), None),
            (np.round(ROTATED, 3), ROTATED, (1, 1), None),
            (ROTATED, FLIPPED, (1, 1), "mm apart"),
            (SHEARED, ROTATED, (1, 1), "mm apart"),
            (None, None, (0, 0), "orientation"),
        ):
            check_as_nibabel(save(labels(), "a.nii", kind, sform, qform, codes), reported)
    mirrored = ROTATED @ np.diag([-1, 1, 1, 1])
    warned(
        "mirrors of each other: the sform (code 4) is used, the qform (code 1) is not",
        save(labels(), sform=mirrored, qform=ROTATED, codes=(4, 1)),
    )
    far = ROTATED.copy()
    far[:3, 3] += (100, -100, 50)
    warned("150 mm apart", save(labels(), sform=far, qform=ROTATED, codes=(1, 1)))
    name = save(labels(), sform=np.diag([2, 3, 4, 1.0]))
    reads_quietly(name)
    patch(name, 252, "<2h", 0, 1)
    patch(name, 80, "<3f", 1, 3, 4)
    warned("its voxels are 2 wide along the 1st axis by its sform, which is used, but 1 by its pixdim", name)


def test_numbers_of_forms():
    for code, place in ((252, 256), (252, 268), (254, 280), (254, 296 + 12)):
        for value in (np.nan, np.inf):
            name = patch(save(labels(), sform=ROTATED, qform=ROTATED, codes=(1, 1)), place, "<f", value)
            refused(FORMAT, "not finite", name)
    only_q = lambda: save(labels(), qform=ROTATED, codes=(0, 1))
    check_as_nibabel(only_q())
    for axis in range(3):
        refused(FORMAT, "not finite", patch(only_q(), 80 + 4 * axis, "<f", np.nan))
    refused(FORMAT, "no rotation", patch(only_q(), 256, "<3f", 1, 1, 0))
    warned("roughly rounded", patch(only_q(), 256, "<3f", 0.708, 0.708, 0))
    refused(FORMAT, "pixdim[0]", patch(only_q(), 76, "<f", -2))
    name = only_q()
    check(labels(), ROTATED[:3], patch(name, 76, "<f", 0), world=RAS)
    check(labels(), ROTATED[:3] @ np.diag([1, 1, -1, 1]), patch(name, 76, "<f", -1), world=RAS)
    name = patch(only_q(), 80, "<f", -0.5)
    check(labels(), ROTATED[:3], name, world=RAS)
    warned("without their signs", name)
    name = patch(only_q(), 88, "<f", 0)
    refused(FORMAT, "spacing along the 3rd axis is 0", name)
    check(labels(), ROTATED[:3], name, world=RAS, spacing=(0, 0, 3))
    refused(FORMAT, "negative", patch(only_q(), 254, "<h", -1))
    flat = ROTATED.copy()
    flat[:3, 2] = flat[:3, 1]
    refused(FORMAT, "plane", save(labels(), sform=flat, codes=(1, 0)))
    warned(
        "the qform (code 1) is not",
        patch(save(labels(), sform=ROTATED, qform=ROTATED, codes=(1, 1)), 256, "<3f", 1, 1, 0),
    )


def test_units():
    for unit, scale, words in ((1, 1e3, "from metres"), (3, 1e-3, "from micrometres")):
        affine = np.diag([1 / scale, 1 / scale, 1 / scale, 1]) @ ROTATED
        name = save(labels(), sform=affine, qform=affine, codes=(1, 1), xyzt_units=unit)
        check(labels(), ROTATED[:3], name, world=RAS)
        warned(words, name)
    warned("unknown", save(labels(), xyzt_units=5))


def test_planes():
    flat = labels(shape=(5, 4))
    for codes in ((1, 0), (1, 1), (0, 1)):
        image = nibabel.Nifti1Image(flat, np.diag([2, 2, 2, 1.0]))
        image.set_sform(np.diag([2, 2, 2, 1.0]), codes[0])
        image.set_qform(np.diag([2, 2, 2, 1.0]), codes[1])
        nibabel.save(image, path("flat.nii"))
        check(flat[:, :, None], np.diag([2, 2, 2, 0])[:3], path("flat.nii"), world=RAS)


def test_analyze_origin():
    name = save(labels("i2"), "o.img", nibabel.Spm2AnalyzeImage, np.diag([-2, 3, 4, 1.0]))
    patch(path("o.hdr"), 253, "<3h", 2, 3, 1)
    check(labels("i2"), np.array([[-2, 0, 0, 2], [0, 3, 0, -6], [0, 0, 4, 0.0]]), name, world=RAS)
    open(path("o.mat"), "w").close()
    warned("'o.mat'", name)
    os.remove(path("o.hdr"))
    refused(FILE, "no file 'o.hdr'", name)


def test_scaling():
    stored = labels("u1", (0, 3, 9))
    scaled = lambda slope, inter: patch(save(stored), 112, "<2f", slope, inter)
    name = scaled(2, 1)
    check(2 * stored.astype(int) + 1, np.eye(3, 4), name, world=RAS)
    warned("2 times the number in the file plus 1", name)
    for slope, inter in ((0, 5), (1, 0), (np.nan, np.nan)):
        check(stored, np.eye(3, 4), scaled(slope, inter), world=RAS)
        reads_quietly(scaled(slope, inter))
    check(stored.astype(int) - 4, np.eye(3, 4), scaled(1, -4), world=RAS)
    check(stored.astype(int) * 1000000, np.eye(3, 4), scaled(1000000, 0), world=RAS)
    refused(FORMAT, "not finite", scaled(np.inf, 0))
    refused(FORMAT, "not finite", scaled(2, np.nan))


def test_frames():
    fields = np.random.default_rng(1).random((6, 5, 4, 3)).astype("f4")
    for name in ("four.nii", "four.nii.gz"):
        nibabel.save(nibabel.Nifti1Image(fields, np.eye(4)), path(name))
        check(fields.argmax(axis=3), np.eye(3, 4), path(name), world=RAS)
    nibabel.save(nibabel.Nifti1Image(fields[:, :, :, None], np.eye(4)), path("five.nii"))
    refused(FORMAT, "3 numbers a voxel", path("five.nii"))
    nibabel.save(nibabel.Nifti1Image(fields[:, :, :, None, None], np.eye(4)), path("six.nii"))
    refused(FORMAT, "6 dimensions", path("six.nii"))


def test_refused():
    for dtype, words in (("c8", "complex"), ("c16", "complex")):
        refused(FORMAT, words, save(np.zeros((4, 3, 5), dtype)))
    refused(FORMAT, "128 bits", patch(save(labels()), 70, "<2h", 1536, 128))
    colours = np.zeros((4, 3, 5), [("R", "u1"), ("G", "u1"), ("B", "u1")])
    refused(FORMAT, "colours", save(colours))
    for intent, words in ((3001, "CIFTI"), (1007, "vectors"), (2003, "colours"), (2001, "points in time")):
        refused(FORMAT, words, patch(save(labels()), 68, "<h", intent))
    check(labels(), np.eye(3, 4), patch(save(labels()), 68, "<h", 1002), world=RAS)
    refused(FORMAT, "bitpix", patch(save(labels()), 72, "<h", 8))
    refused(FORMAT, "no type", patch(save(labels()), 70, "<h", 77))
    refused(FORMAT, "single bits", patch(save(labels()), 70, "<2h", 1, 1))
    for count in (0, 8, -1):
        refused(FORMAT, "", patch(save(labels()), 40, "<h", count))
    refused(FORMAT, "dim[2] is 0", patch(save(labels()), 44, "<h", 0))
    for offset in (0, 351, 352.5, np.nan, -1):
        refused(FORMAT, "vox_offset", patch(save(labels()), 108, "<f", offset))
    refused(FORMAT, "missing", patch(save(labels()), 108, "<f", 353))
    open(path("text.nii"), "w").write("no volume" * 100)
    refused(FORMAT, "no header", path("text.nii"))
    open(path("vast.nii"), "wb").write(open(patch(save(labels()), 42, "<3h", 32767, 32767, 32767), "rb").read())
    refused(FORMAT, "missing", path("vast.nii"))
    open(path("vast.nii.gz"), "wb").write(gzip.compress(open(path("vast.nii"), "rb").read()))
    refused(FORMAT, "claims", path("vast.nii.gz"))


def test_extensions():
    for kind in (nibabel.Nifti1Image, nibabel.Nifti2Image):
        image = kind(labels(), np.eye(4))
        image.header.extensions.append(nibabel.nifti1.Nifti1Extension(6, b"a comment" * 1000))
        image.header.extensions.append(nibabel.nifti1.Nifti1Extension(6, b"another"))
        nibabel.save(image, path("e.nii"))
        check(labels(), np.eye(3, 4), path("e.nii"), world=RAS)
        reads_quietly(path("e.nii"))
    image = nibabel.Nifti1Image(labels(), np.eye(4))
    image.header.extensions.append(nibabel.nifti1.Nifti1Extension(6, b"a comment" * 1000))
    nibabel.save(image, path("e.nii"))
    refused(FORMAT, "extension", patch(path("e.nii"), 352, "<i", 1 << 30))


def test_length():
    """A file that is cut short anywhere is refused; more bytes than voxels are reported."""
    voxels = labels("u1", (0, 3, 7))
    data = open(save(voxels), "rb").read()
    packed = gzip.compress(data)
    for name, content in (("cut.nii", data), ("cut.nii.gz", packed)):
        for length in range(0, len(content), len(content) // 40):
            open(path(name), "wb").write(content[:length])
            run, _ = run_dump([path(name)])
            assert run.returncode == 1, "%d of %d bytes were enough" % (length, len(content))
        more = content + bytes(5) if name == "cut.nii" else gzip.compress(data + bytes(5))
        open(path(name), "wb").write(more)
        check(voxels, np.eye(3, 4), path(name), world=RAS)
        warned("5 bytes behind its voxels", path(name))
    refused(FORMAT, "twice as many", write("twice.nii", data + bytes(voxels.size)))


def test_behind_gzip():
    """What follows a gzip stream is no part of it, unless it is another one."""
    voxels = labels("u1", (0, 3, 7))
    data = open(save(voxels), "rb").read()
    for rest in (bytes(512), b"\n", b"rubbish"):
        name = write("z.nii.gz", gzip.compress(data) + rest)
        check(voxels, np.eye(3, 4), name, world=RAS)
        warned("%d byte%s behind its compressed data" % (len(rest), "s" * (len(rest) > 1)), name)
    name = write("z.nii.gz", gzip.compress(data[:90]) + gzip.compress(data[90:400]) + gzip.compress(data[400:]))
    check(voxels, np.eye(3, 4), name, world=RAS)
    reads_quietly(name)
    refused(FORMAT, "missing", write("z.nii.gz", gzip.compress(data[:400]) + b"rubbish" + gzip.compress(data[400:])))


run_tests(globals())
