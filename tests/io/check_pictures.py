"""Pictures as Pillow writes them, and damaged ones: read pixel by pixel, or refused. check_pictures.py DUMP_VOLUME"""
import struct
import zlib

import numpy as np
from PIL import Image

from volume_reading import *

CUBES = np.eye(3, 4)


def labels(*shape, dtype="u1", most=4, seed=0):
    return np.random.default_rng(seed).integers(0, most, shape).astype(dtype)


def check_picture(pixels, name, **options):
    """Pixels as [row, column], the uppermost first."""
    check(pixels.astype(np.int64).T[:, :, None], CUBES, path(name), **options)


def test_bits():
    for ending in ("png", "bmp"):
        for bits in (1, 2, 4, 8):
            if (ending, bits) == ("bmp", 2):
                continue
            pixels = labels(7, 13, most=1 << bits)
            picture = Image.fromarray(pixels, "P")
            picture.putpalette([255, 0, 0, 0, 255, 0] * (1 << bits >> 1))
            picture.save(path("p." + ending), bits=bits)
            check_picture(pixels, "p." + ending)
        grey = labels(7, 13, most=256)
        Image.fromarray(grey).save(path("g." + ending))
        check_picture(grey, "g." + ending)
        Image.fromarray(grey > 100).save(path("b." + ending))
        check_picture(grey > 100, "b." + ending)
        reads_quietly(path("b." + ending))
    wide = labels(7, 13, dtype="u2", most=65536)
    Image.fromarray(wide).save(path("w.png"))
    check_picture(wide, "w.png")


def png_chunk(kind, data):
    return len(data).to_bytes(4, "big") + kind + data + zlib.crc32(kind + data).to_bytes(4, "big")


def write_png(name, width, height, bits, rows, before=b""):
    header = width.to_bytes(4, "big") + height.to_bytes(4, "big") + bytes([bits, 0, 0, 0, 0])
    with open(path(name), "wb") as file:
        file.write(
            b"\x89PNG\r\n\x1a\n"
            + png_chunk(b"IHDR", header)
            + before
            + png_chunk(b"IDAT", zlib.compress(rows))
            + png_chunk(b"IEND", b"")
        )


def test_png_by_hand():
    """Grey numbers of 2 bits are not stretched to the range of a byte."""
    write_png("two.png", 4, 2, 2, bytes([0, 0b00011011, 0, 0b11100100]))
    check_picture(np.array([[0, 1, 2, 3], [3, 2, 1, 0]]), "two.png")
    write_png("moving.png", 4, 2, 2, bytes([0, 1, 0, 2]), png_chunk(b"acTL", bytes(8)))
    refused(FORMAT, "animation", path("moving.png"))
    write_png("vast.png", 1 << 30, 1 << 30, 8, bytes(100))
    refused(FORMAT, "more voxels than its bytes", path("vast.png"))
    write_png("short.png", 4, 2, 2, bytes([0, 1]))
    refused(FORMAT, "damaged", path("short.png"))


def test_bmp_by_hand():
    """With the header of OS/2, which Pillow reads the same; and what no BMP has."""
    pixels = labels(3, 5, most=200)
    rows = b"".join(row.tobytes().ljust(8, b"\0") for row in pixels[::-1])
    colours = bytes(3 * 256)

    def bmp(header, data=rows):
        start = 14 + len(header) + len(colours)
        return write("o.bmp", b"BM" + struct.pack("<IHHI", start + len(data), 0, 0, start), header, colours, data)

    name = bmp(struct.pack("<IHHHH", 12, 5, 3, 1, 8))
    assert (np.array(Image.open(name)) == pixels).all()
    check_picture(pixels, "o.bmp")
    reads_quietly(name)
    newer = lambda width, height, bits=8, kind=0: struct.pack("<IiiHHI", 40, width, height, 1, bits, kind) + bytes(20)
    bmp(newer(5, 3))
    check_picture(pixels, "o.bmp")
    bmp(newer(5, -3))
    check_picture(pixels[::-1], "o.bmp")
    refused(FORMAT, "its header has 13 bytes, which no BMP has", bmp(struct.pack("<IHHHH", 13, 5, 3, 1, 8)))
    refused(FORMAT, "it has 3 bits a voxel, which no BMP has", bmp(newer(5, 3, 3)))
    refused(FORMAT, "it is compressed (number 1)", bmp(newer(5, 3, 8, 1)))
    for width, height in ((0, 3), (-5, 3), (5, 0)):
        refused(FORMAT, "it has no voxels", bmp(newer(width, height)))


def test_jpeg():
    pixels = np.kron(labels(5, 6), np.full((8, 8), 60, "u1"))
    for options in ({"quality": 100}, {"quality": 100, "progressive": True}):
        Image.fromarray(pixels).save(path("j.jpg"), **options)
        check_picture(pixels, "j.jpg")
        warned("JPEG", path("j.jpg"))


def test_colours():
    for ending in ("png", "jpg", "bmp"):
        Image.fromarray(np.zeros((4, 6, 3), "u1")).save(path("c." + ending))
        refused(FORMAT, "colours", path("c." + ending))
    Image.fromarray(np.zeros((4, 6, 2), "u1"), "LA").save(path("a.png"))
    refused(FORMAT, "2 numbers a voxel", path("a.png"))


def test_damaged():
    """Cut anywhere: refused. Changed: read or refused. Nothing is printed, and nothing crashes."""
    pixels = labels(20, 23, most=200)
    random = np.random.default_rng(3)
    for ending in ("png", "jpg", "bmp"):
        Image.fromarray(pixels).save(path("d." + ending))
        data = open(path("d." + ending), "rb").read()
        for length in range(2 if ending != "png" else 8, len(data), len(data) // 40):
            open(path("x." + ending), "wb").write(data[:length])
            run, _ = run_dump([path("x." + ending)])
            assert run.returncode == 1, "%d of %d bytes were enough" % (length, len(data))
        for _ in range(25):
            damaged = bytearray(data)
            for _ in range(3):
                damaged[random.integers(len(data))] = random.integers(256)
            open(path("x." + ending), "wb").write(damaged)
            run_dump([path("x." + ending)])
    for ending, head in (("png", b"\x89PNG\r\n\x1a\n"), ("jpg", b"\xff\xd8\xff\xe0"), ("bmp", b"BM")):
        for size in (0, 8, 300):
            open(path("junk." + ending), "wb").write(head + random.bytes(size))
            refused(FORMAT, "", path("junk." + ending))


run_tests(globals())
