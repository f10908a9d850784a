"""TIFF files as tifffile, scikit-image, Pillow and ImageJ write them: read voxel by voxel with their place, or refused
by what they are. check_tiff.py DUMP_VOLUME"""
import struct
import zlib

import numpy as np
import skimage.io
import tifffile
from PIL import Image

from volume_reading import *

CUBES = np.eye(3, 4)
UNSUPPORTED = -10


def labels(*shape, dtype="u1", most=4, seed=0):
    return np.random.default_rng(seed).integers(0, most, shape).astype(dtype)


def write(voxels, name="a.tif", **options):
    options.setdefault("photometric", "minisblack")
    tifffile.imwrite(path(name), voxels, **options)
    return path(name)


def check_stack(voxels, affine, *paths, **options):
    """Voxels as [page, row, column]."""
    check(voxels.astype(np.int64).T, affine, *paths, **options)


def scaled(x, y, z):
    return np.column_stack([np.diag([x, y, z]), np.zeros(3)])


def test_tifffile():
    for dtype in ("u1", "i1", "u2", "i2", "u4", "i4", "u8", "i8", "f4", "f8"):
        voxels = labels(3, 21, 37, dtype=dtype)
        if dtype[0] == "i":
            voxels -= 2
        for options in (
            {"byteorder": ">"},
            {"bigtiff": True},
            {"tile": (16, 32), "compression": "zlib"},
            {"rowsperstrip": 5, "contiguous": False},
        ):
            check_stack(voxels, CUBES, write(voxels, **options))
        reads_quietly(path("a.tif"))
    mask = labels(3, 21, 37, dtype=bool, most=2)
    check_stack(mask, CUBES, write(mask))
    single = labels(21, 37, dtype="i4") * 20000
    check_stack(single[None], CUBES, write(single))
    for dtype, words in (("f2", "16 bits"), ("c8", "complex"), ("c16", "complex")):
        refused(FORMAT, words, write(np.zeros((3, 4, 5), dtype)))


def test_floating_predictor():
    """By hand in either order of bytes: the bytes of a row by their weight, the greatest first, then differences."""
    voxels = np.arange(256, dtype="f4").reshape(1, 16, 16) * 1000
    planes = voxels[0].astype(">f4").view("u1").reshape(16, -1, 4).transpose(0, 2, 1).reshape(16, -1)
    data = zlib.compress(np.diff(planes, axis=1, prepend=np.zeros((16, 1), "u1")).astype("u1").tobytes())
    tags = (
        (256, 16),
        (257, 16),
        (258, 32),
        (259, 8),
        (262, 1),
        (273, 300),
        (277, 1),
        (278, 16),
        (279, len(data)),
        (317, 3),
        (339, 3),
    )
    for order, mark in (("<", b"II*\0"), (">", b"MM\0*")):
        head = mark + struct.pack(order + "IH", 8, len(tags))
        head += b"".join(struct.pack(order + "HHIHH", tag, 3, 1, value, 0) for tag, value in tags) + bytes(4)
        open(path("f.tif"), "wb").write(head.ljust(300, b"\0") + data)
        check_stack(voxels, CUBES, path("f.tif"))


def test_programs():
    voxels = labels(5, 21, 37, dtype="i4") * 20000  # three planes would be taken for colours
    skimage.io.imsave(path("s.tif"), voxels, check_contrast=False)
    check_stack(voxels, CUBES, path("s.tif"))
    pages = [Image.fromarray(page) for page in voxels]
    pages[0].save(path("p.tif"), save_all=True, append_images=pages[1:])
    check_stack(voxels, CUBES, path("p.tif"))
    grey = labels(3, 21, 37)
    pages = [Image.fromarray(page) for page in grey]
    for compression in ("tiff_lzw", "packbits", "tiff_adobe_deflate", "tiff_deflate"):
        pages[0].save(path("p.tif"), save_all=True, append_images=pages[1:], compression=compression, dpi=(300, 300))
        check_stack(grey, CUBES, path("p.tif"))
        reads_quietly(path("p.tif"))
    for page, name in zip(pages, ("n1.tif", "n2.tif", "n3.tif")):
        page.save(path(name))
    check_stack(grey, CUBES, path("n?.tif"))
    mask = Image.fromarray(grey[0] > 1)
    for compression in ("group4", "group3", "tiff_lzw"):
        mask.save(path("p.tif"), compression=compression)
        check_stack(grey[:1] > 1, CUBES, path("p.tif"))
    check_stack(grey > 1, CUBES, write(grey > 1, photometric="miniswhite"))
    warned("MinIsWhite", path("a.tif"))
    Image.fromarray(grey[0]).save(path("p.tif"), compression="jpeg")
    warned("JPEG", path("p.tif"))


def test_colours():
    refused(FORMAT, "colours", write(np.zeros((5, 6, 3), "u1"), photometric="rgb"))
    refused(FORMAT, "colours", write(np.zeros((3, 5, 6, 3), "u1"), photometric="rgb"))
    refused(FORMAT, "colours", write(np.zeros((3, 5, 6), "u1"), photometric="rgb", planarconfig="separate"))
    refused(FORMAT, "colours", write(np.zeros((3, 5, 6, 3), "u1"), photometric="rgb", imagej=True))
    refused(FORMAT, "2 numbers a voxel", write(np.zeros((5, 6, 2), "u1"), planarconfig="contig", extrasamples=[0]))


def test_imagej():
    voxels = labels(5, 21, 37, dtype="u2") * np.uint16(300)
    metadata = {"spacing": 0.3, "unit": "um"}
    for unit in ("um", "micron", "\\u00B5m"):
        name = write(voxels, imagej=True, resolution=(10, 4), metadata={"axes": "ZYX", "spacing": 0.3, "unit": unit})
        check_stack(voxels, scaled(0.1, 0.25, 0.3), name)
        warned("0.1 x 0.25 x 0.3 um", name)
    check_stack(voxels, scaled(2, 3, 7), name, spacing=(2, 3, 7))
    name = write(voxels, imagej=True, resolution=(10, 10), metadata={"axes": "ZYX", "unit": "mm"})
    check_stack(voxels, scaled(0.1, 0.1, 1), name)
    warned("does not give the last", name)
    name = write(voxels[0], imagej=True, resolution=(10, 10), metadata={"unit": "mm"})
    check_stack(voxels[:1], scaled(0.1, 0.1, 0.1), name)
    check_stack(voxels, CUBES, write(voxels, imagej=True, metadata={"axes": "ZYX"}))
    reads_quietly(path("a.tif"))
    for place, axes, words in ((1, "ZCYX", "2 channels"), (0, "TZYX", "2 points in time")):
        name = write(
            np.stack([voxels] * 2, place), imagej=True, resolution=(10, 10), metadata={"axes": axes, **metadata}
        )
        refused(FORMAT, words, name)
    refused(FORMAT, "5 channels", write(voxels, imagej=True))  # what tifffile makes of a stack without axes
    name = write(voxels, imagej=True, metadata={"axes": "TYX"})
    refused(FORMAT, "5 points in time", name)


def test_imagej_behind_one_page():
    """Stacks above 4 GB have one page, behind which the voxels of the others lie; big-endian, as Java writes."""
    voxels = labels(5, 21, 37, dtype="u2") * np.uint16(300)
    description = b"ImageJ=1.53t\nimages=5\nslices=5\nunit=mm\nspacing=2\n\0"
    entries = [
        (256, 3, 1, 37 << 16),
        (257, 3, 1, 21 << 16),
        (258, 3, 1, 16 << 16),
        (259, 3, 1, 1 << 16),
        (262, 3, 1, 1 << 16),
        (270, 2, len(description), 200),
        (273, 4, 1, 300),
        (277, 3, 1, 1 << 16),
        (278, 3, 1, 21 << 16),
        (279, 4, 1, 37 * 21 * 2),
        (282, 5, 1, 280),
        (283, 5, 1, 280),
    ]
    head = b"MM\0*" + struct.pack(">IH", 8, len(entries)) + b"".join(struct.pack(">HHII", *e) for e in entries)
    head = (head + bytes(4)).ljust(200, b"\0") + description
    head = head.ljust(280, b"\0") + struct.pack(">II", 4, 1)
    data = head.ljust(300, b"\0") + voxels.astype(">u2").tobytes()
    open(path("big.tif"), "wb").write(data)
    check_stack(voxels, scaled(0.25, 0.25, 2), path("big.tif"))
    open(path("big.tif"), "wb").write(data[:-1])
    refused(FORMAT, "5 slices", path("big.tif"))
    open(path("big.tif"), "wb").write(data[: 300 + 37 * 21 * 2])
    check_stack(voxels[:1], scaled(0.25, 0.25, 2), path("big.tif"))
    warned("one page", path("big.tif"))


def test_tifffile_shapes():
    voxels = labels(2, 3, 21, 37)
    refused(FORMAT, "shape", write(voxels))
    refused(FORMAT, "2 channels", write(voxels[:, 0], metadata={"axes": "CYX"}))
    refused(FORMAT, "2 points in time", write(voxels[:, 0], metadata={"axes": "TYX"}))
    check_stack(voxels[0], CUBES, write(voxels[0], metadata={"axes": "ZYX"}))
    check_stack(voxels[0], CUBES, write(voxels[:1]))
    with tifffile.TiffWriter(path("two.tif")) as file:  # a stack of grey values and one of labels
        file.write(voxels[0], photometric="minisblack")
        file.write(voxels[1], photometric="minisblack")
    refused(FORMAT, "3 slices, but it has 6 pages", path("two.tif"))
    with tifffile.TiffWriter(path("one.tif")) as file:
        for page in voxels[0]:
            file.write(page, photometric="minisblack")
    check_stack(voxels[0], CUBES, path("one.tif"))


def test_ome():
    voxels = labels(3, 21, 37)
    sizes = {"PhysicalSizeX": 0.1, "PhysicalSizeY": 0.2, "PhysicalSizeZ": 0.5}
    name = write(voxels, "a.ome.tif", ome=True, metadata={"axes": "ZYX", **sizes})
    check_stack(voxels, scaled(0.1, 0.2, 0.5), name)
    warned("0.1 x 0.2 x 0.5 um", name)
    units = {"PhysicalSizeXUnit": "mm", "PhysicalSizeYUnit": "mm", "PhysicalSizeZUnit": "µm"}
    name = write(voxels, "a.ome.tif", ome=True, metadata={"axes": "ZYX", **sizes, **units})
    check_stack(voxels, scaled(0.1, 0.2, 0.0005), name)
    warned("mm", name)
    check_stack(voxels, CUBES, write(voxels, "a.ome.tif", ome=True, metadata={"axes": "ZYX"}))
    for only in "PhysicalSizeX", "PhysicalSizeZ":
        name = write(voxels, "a.ome.tif", ome=True, metadata={"axes": "ZYX", only: sizes[only]})
        check_stack(voxels, CUBES, name)
        warned("OME's '%s' is not used" % only, name)
    four = np.stack([voxels] * 2)
    refused(FORMAT, "2 channels", write(four, "a.ome.tif", ome=True, metadata={"axes": "CZYX"}))
    refused(FORMAT, "2 points in time", write(four, "a.ome.tif", ome=True, metadata={"axes": "TZYX"}))
    with tifffile.TiffWriter(path("two.ome.tif"), ome=True) as file:
        for _ in range(2):
            file.write(voxels, photometric="minisblack", metadata={"axes": "ZYX"})
    refused(FORMAT, "several images", path("two.ome.tif"))


def test_pyramid():
    """The smaller copies of a pyramid are no slices, whether they have tags of their own or lie in SubIFDs."""
    voxels = labels(3, 32, 48)
    with tifffile.TiffWriter(path("sub.tif")) as file:
        file.write(voxels, photometric="minisblack", subifds=1, tile=(16, 16))
        file.write(voxels[:, ::2, ::2], photometric="minisblack", subfiletype=1, tile=(16, 16))
    check_stack(voxels, CUBES, path("sub.tif"))
    with tifffile.TiffWriter(path("pyramid.tif")) as file:
        for page in voxels:
            file.write(page, photometric="minisblack")
            file.write(page[::2, ::2], photometric="minisblack", subfiletype=1)
    check_stack(voxels, CUBES, path("pyramid.tif"))
    warned("3 of its 6 pages", path("pyramid.tif"))
    with tifffile.TiffWriter(path("untold.tif")) as file:
        file.write(voxels[0], photometric="minisblack")
        file.write(voxels[0, ::2, ::2], photometric="minisblack")
    refused(FORMAT, "the 2nd page has 24 x 16 voxels, but the 1st page has 48 x 32", path("untold.tif"))


def test_told():
    voxels = labels(3, 21, 37)
    check_stack(voxels, CUBES, write(voxels, extratags=[(274, "H", 1, 4, True)]))
    warned("orientation", path("a.tif"))
    check_stack(voxels, CUBES, write(voxels, extratags=[(33550, "d", 3, (0.5, 0.5, 0.0), True)]))
    warned("GeoTIFF", path("a.tif"))
    check_stack(voxels, CUBES, write(voxels, extratags=[(65000, "s", 0, "a private tag", True)]))
    reads_quietly(path("a.tif"))
    refused(UNSUPPORTED, "Zeiss", write(voxels, extratags=[(34412, "B", 4, b"abcd", True)]))
    refused(UNSUPPORTED, "MetaMorph", write(voxels, extratags=[(33629, "I", 3, (1, 2, 3), True)]))


def page(next_page=0, start=8, **changes):
    """The directory of a page of 6 x 4 bytes that lie behind it: tags as t258=(type, count, value)."""
    tags = {256: 6, 257: 4, 258: 8, 259: 1, 262: 1, 273: start + 200, 277: 1, 278: 4, 279: 24}
    entries = {tag: (4, 1, value) for tag, value in tags.items()}
    entries.update((int(tag[1:]), entry) for tag, entry in changes.items())
    table = b"".join(struct.pack("<HHII", tag, *entries[tag]) for tag in sorted(entries) if entries[tag])
    table = struct.pack("<H", len(table) // 12) + table + struct.pack("<I", next_page)
    return table.ljust(200, b"\0") + VOXELS.tobytes()


VOXELS = labels(1, 4, 6, most=200)


def by_hand(*pages, first=8):
    with open(path("h.tif"), "wb") as file:
        file.write(b"II*\0" + struct.pack("<I", first) + b"".join(pages))
    return path("h.tif")


def test_compressions_that_are_refused():
    check_stack(VOXELS, CUBES, by_hand(page()))
    for number, name in (
        (6, "old JPEG"),
        (34661, "JBIG"),
        (34712, "JPEG 2000"),
        (33003, "JPEG 2000"),
        (33005, "JPEG 2000"),
        (50001, "WebP"),
        (50002, "JPEG XL"),
        (52546, "JPEG XL"),
        (12345, "number 12345"),
    ):
        refused(FORMAT, "its compression, %s, cannot be read: save" % name, by_hand(page(t259=(3, 1, number))))
    for number in 1, 32773:
        words = "it has a predictor, but a compression that knows none"
        refused(FORMAT, words, by_hand(page(t259=(3, 1, number), t317=(3, 1, 2))))


def test_types_that_are_refused():
    for bits, sample_format, words in (
        (4, 2, "its voxels are signed numbers of 4 bits; 8, 16, 32 or 64 are wanted"),
        (12, 1, "its voxels are unsigned numbers of 12 bits"),
        (8, 4, "their type is not known"),
        (12, 2, "its voxels are signed numbers of 12 bits"),
        (8, 9, "it cannot be opened"),
    ):
        refused(FORMAT, words, by_hand(page(t258=(3, 1, bits), t339=(3, 1, sample_format))))
    for tag in "t256", "t257":
        refused(FORMAT, "it cannot be opened", by_hand(page(**{tag: (4, 1, 0)})))
    refused(FORMAT, "it cannot be opened", by_hand(page(t273=None, t279=None)))
    refused(UNSUPPORTED, "it has several slices in one (ImageDepth)", by_hand(page(t32997=(4, 1, 2))))


def test_directories_that_are_refused():
    check_stack(np.concatenate([VOXELS, VOXELS]), CUBES, by_hand(page(8 + 224), page(start=8 + 224)))
    refused(FORMAT, "its pages run in a circle", by_hand(page(8)))
    refused(FORMAT, "it has no pages", by_hand(first=0))
    with open(path("b.tif"), "wb") as file:
        file.write(b"II+\0" + struct.pack("<HHQ", 4, 0, 16) + bytes(40))
    refused(FORMAT, "its BigTIFF header is damaged", path("b.tif"))
    many = [
        struct.pack("<H", 900) + b"".join(struct.pack("<HHII", 1000 + 900 * k + t, 1, 1, 0) for t in range(900))
        for k in range(2)
    ]
    size = len(many[0]) + 4
    ends = [struct.pack("<I", 8 + size), struct.pack("<I", 0)]
    refused(FORMAT, "it has more than 1000 kinds of tags", by_hand(*[a + b for a, b in zip(many, ends)]))
    whole = 8 + 18 * 60
    shared = [struct.pack("<HHHIII", 1, 270, 2, 100000, whole, 8 + 18 * (k + 1) if k < 59 else 0) for k in range(60)]
    refused(FORMAT, "the tags of its pages lie over each other", by_hand(*shared, bytes(100000)))
    endless = [struct.pack("<HHHIII", 1, 256, 4, 1, 6, 8 + 18 * (k + 1)) for k in range(65536)]
    refused(UNSUPPORTED, "it has more than 65535 pages", by_hand(*endless))


run_tests(globals())
