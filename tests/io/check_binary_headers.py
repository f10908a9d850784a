"""GIPL and MRC: types, orders of bytes, places, and files that are cut short. check_binary_headers.py DUMP_VOLUME"""
import gzip
import struct

import numpy as np

from volume_reading import *

SHAPE = (4, 3, 5)


def gipl(voxels, kind, mark=719555000):
    head = bytearray(256)
    struct.pack_into(">4HH4f", head, 0, *voxels.shape, 1, kind, 0.5, 2, 3, 0)
    struct.pack_into(">3d", head, 204, 10, -20, 30)
    struct.pack_into(">I", head, 252, mark)
    return bytes(head) + voxels.astype(voxels.dtype.newbyteorder(">")).tobytes(order="F")


def mrc(voxels, mode, order, extension=b"", version=20140, **changes):
    head = bytearray(1024)
    struct.pack_into(order + "4i", head, 0, *voxels.shape, mode)
    struct.pack_into(order + "3i3f3f3i", head, 28, *voxels.shape, 2, 6, 15, 90, 90, 90, 1, 2, 3)
    struct.pack_into(order + "2i", head, 88, 1, len(extension))
    struct.pack_into(order + "i", head, 108, version)
    struct.pack_into(order + "3f", head, 196, 10, -20, 30)
    head[208:214] = b"MAP " + (b"DD" if order == "<" else b"\x11\x11")
    for place, value in changes.items():
        struct.pack_into(order + "i", head, int(place[1:]), value)
    return bytes(head) + extension + voxels.astype(voxels.dtype.newbyteorder(order)).tobytes(order="F")


def test_gipl():
    affine = np.array([[0.5, 0, 0, 10], [0, 2, 0, -20], [0, 0, 3, 30.0]])
    for dtype, kind, values in (
        ("i1", 7, (-3, 0, 9)),
        ("u1", 8, (0, 200)),
        ("i2", 15, (-300, 0, 7)),
        ("u2", 16, (0, 60000)),
        ("u4", 31, (0, 70000)),
        ("i4", 32, (-70000, 1)),
        ("f4", 64, (0, 5)),
        ("f8", 65, (0, 5)),
    ):
        voxels = random_labels(SHAPE, dtype, values)
        for mark in 719555000, 4026526128:
            check(voxels.astype(int), affine, write("v.gipl", gipl(voxels, kind, mark)))
        check(voxels.astype(int), affine, write("v.gipl.gz", gzip.compress(gipl(voxels, kind))))
    refused(FORMAT, "'image type' is '192'", write("v.gipl", gipl(voxels, 192)))
    refused(FORMAT, "missing", write("v.gipl", gipl(voxels, 65)[:-1]))
    refused(FORMAT, "too early", write("v.gipl.gz", gzip.compress(gipl(voxels, 65))[:-1]))


def test_mrc():
    affine = np.array([[0.5, 0, 0, 10], [0, 2, 0, -20], [0, 0, 3, 30.0]])
    for order in "<", ">":
        for dtype, mode, values in (
            ("i1", 0, (-3, 0, 9)),
            ("i2", 1, (-300, 0, 7)),
            ("f4", 2, (0, 5)),
            ("u2", 6, (0, 60000)),
        ):
            voxels = random_labels(SHAPE, dtype, values)
            for extension in b"", b"x" * 80:
                check(voxels.astype(int), affine, write("v.mrc", mrc(voxels, mode, order, extension)))
    old = random_labels(SHAPE, "u1", (0, 200))
    check(old, affine, write("v.rec", mrc(old, 0, "<", version=0)))
    warned("positive numbers", path("v.rec"))
    warned("negative numbers", write("v.mrc", mrc(old, 0, "<")))
    refused(FORMAT, "'MODE' is '4'", write("v.mrc", mrc(old, 4, "<")))
    refused(FORMAT, "MAPC", write("v.mrc", mrc(old, 0, "<", _64=2)))
    refused(FORMAT, "right angles", write("v.mrc", mrc(old, 0, "<", _52=struct.unpack("<i", struct.pack("<f", 60))[0])))
    refused(FORMAT, "NX, NY, NZ", write("v.mrc", mrc(old, 0, "<", _4=-1)))
    refused(FORMAT, "missing", write("v.mrc", mrc(old, 0, "<", _4=2**30)))
    refused(FORMAT, "missing", write("v.mrc", mrc(old, 0, "<")[:-1]))


def test_mrc_of_imod():
    """Flags behind the stamp tell what bytes and the origin are."""
    stamp = struct.unpack("<i", b"IMOD")[0]
    voxels = random_labels(SHAPE, "i1", (-3, 0, 9))
    place = np.array([[0.5, 0, 0, 10], [0, 2, 0, -20], [0, 0, 3, 30.0]])
    inverted = place * [1, 1, 1, -1]
    imod = lambda flags, **changes: write("v.mrc", mrc(voxels, 0, "<", _152=stamp, _156=flags, **changes))
    for version in 20140, 0:
        check(voxels.astype(int), place, imod(1 | 4, version=version))
        check(voxels.view("u1"), place, imod(4, version=version))
        warned("positive numbers", path("v.mrc"))
    check(voxels.astype(int), place, imod(1, version=20140))
    check(voxels.astype(int), inverted, imod(1, version=0))
    warned("origin is taken with the other sign", path("v.mrc"))
    voxels = np.abs(voxels)
    check(voxels.astype(int), np.diag([0.5, 2, 3, 0])[:3], imod(0, version=0, _196=0, _200=0, _204=0))
    reads_quietly(path("v.mrc"))
    refused(FORMAT, "'MODE' is '0': its bytes are pairs of numbers of 4 bits", imod(16, version=0))
    # Without the stamp the flags are those of another program.
    check(voxels.astype(int), place, write("v.mrc", mrc(voxels, 0, "<", _156=16 | 4)))


def test_mrc_places():
    voxels = random_labels(SHAPE, "u1", (0, 1, 9))
    whole = np.array([[0.5, 0, 0, 10], [0, 2, 0, -20], [0, 0, 3, 30.0]])
    changed = lambda **changes: write("v.mrc", mrc(voxels, 0, "<", **changes))
    bits = lambda number: struct.unpack("<i", struct.pack("<f", number))[0]
    check(voxels, whole, changed())
    reads_quietly(path("v.mrc"))
    for what in ({"_32": 0}, {"_44": bits(0)}, {"_32": -3}):
        affine = whole.copy()
        affine[1, 1] = 1
        check(voxels, affine, changed(**what))
        warned("no size of voxels along the 2nd axis, which is taken for 1", path("v.mrc"))
    refused(FORMAT, "'CELLA' is '-15", changed(_48=bits(-15)))
    refused(FORMAT, "'ISPG' is '401': a stack of volumes", changed(_88=401))
    refused(FORMAT, "'NSYMBT' is '-1'", changed(_92=-1))
    refused(FORMAT, "angles", changed(_56=bits(float("nan"))))
    affine = whole.copy()
    affine[2, 3] = 0
    check(voxels, affine, changed(_16=7, _24=-4, _204=0))
    warned("its first voxel has the number -4 along the 3rd axis, which is not used", path("v.mrc"))
    run, _ = run_dump([path("v.mrc")])
    assert run.stdout.count("warning: ") == 1, run.stdout  # the origin along x is given
    check(voxels, whole, changed(_212=0))  # as old programs leave it
    refused(FORMAT, "'MACHST' is '85'", changed(_212=85))


run_tests(globals())
