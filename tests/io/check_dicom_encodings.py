"""How DICOM lays out elements, sequences and pixels: orders of bytes, undefined lengths, compression.
check_dicom_encodings.py DUMP_VOLUME"""
import io
import os
import struct

import numpy as np
import pydicom
from PIL import Image
from pydicom.encaps import encapsulate
from pydicom.filebase import DicomBytesIO
from pydicom.filewriter import write_dataset
from pydicom.uid import (
    DeflatedExplicitVRLittleEndian,
    ExplicitVRBigEndian,
    ExplicitVRLittleEndian,
    ImplicitVRLittleEndian,
    JPEG2000Lossless,
    JPEGBaseline8Bit,
    RLELossless,
)

from dicom_files import *


def test_bits_in_the_middle():
    voxels = random_labels((6, 4, 1), (0, 3, 900))
    alone = AFFINE.copy()
    alone[2, 2] = 1
    for high in (11, 13, 15):
        dataset = slice_of(voxels[:, :, 0], (10, 20, 30))
        dataset.BitsStored, dataset.HighBit = 12, high
        dataset.PixelData = ((voxels[:, :, 0].T << (high - 11)) | (1 << (high - 11)) - 1).astype("<u2").tobytes()
        check(voxels, alone, save(dataset, "bits.dcm"), reported=["HighBit"] if high != 11 else [])
    dataset.HighBit = 16
    refused(FORMAT, "bit 16", save(dataset, "bits.dcm"))
    small = voxels % 256
    dataset = slice_of(small[:, :, 0], (10, 20, 30))
    set_pixels(dataset, small.transpose(2, 1, 0), bits=8)
    dataset.PixelData = small[:, :, 0].T.astype("u1").reshape(-1, 2)[:, ::-1].tobytes()  # words, high byte first
    dataset["PixelData"].VR = "OW"
    check(small, alone, save(dataset, "words.dcm", ExplicitVRBigEndian))


def test_encodings():
    voxels = random_labels((6, 4, 1), (0, 3, 900))
    alone = AFFINE.copy()
    alone[2, 2] = 1
    dataset = lambda: slice_of(voxels[:, :, 0], (10, 20, 30))
    for name, syntax in (
        ("implicit", ImplicitVRLittleEndian),
        ("explicit", ExplicitVRLittleEndian),
        ("deflated", DeflatedExplicitVRLittleEndian),
    ):
        check(voxels, alone, save(dataset(), name + ".dcm", syntax))
    big = dataset()
    big.PixelData = voxels[:, :, 0].T.astype(">u2").tobytes()
    check(voxels, alone, save(big, "big.dcm", ExplicitVRBigEndian))
    data = open(path("implicit.dcm"), "rb").read()
    body = data.index(b"\x08\0\x16\0")
    open(path("bare.dcm"), "wb").write(data[body:])  # as files before 1993
    check(voxels, alone, path("bare.dcm"))


def test_compressed():
    voxels = random_labels((6, 4, 1), (0, 3, 900))
    alone = AFFINE.copy()
    alone[2, 2] = 1
    dataset = slice_of(voxels[:, :, 0], (10, 20, 30))
    dataset.PixelData = encapsulate([packed_by_runs(voxels[:, :, 0].T)])
    dataset["PixelData"].is_undefined_length = True
    check(voxels, alone, save(dataset, "runs.dcm", RLELossless))
    dataset.PixelData = encapsulate([packed_by_runs(voxels[:, :, 0].T)[:80]])
    refused(FORMAT, "damaged", save(dataset, "short_runs.dcm", RLELossless))


def test_one_slice_in_all_encodings():
    """Files that come with pydicom: the same slice, plain and compressed in several ways."""
    folder = os.path.join(os.path.dirname(pydicom.__file__), "data", "test_files")
    plain = pydicom.dcmread(os.path.join(folder, "MR_small.dcm"))
    across, down = (np.array(plain.ImageOrientationPatient[i : i + 3], float) for i in (0, 3))
    steps = [
        across * plain.PixelSpacing[1],
        down * plain.PixelSpacing[0],
        np.cross(across, down) * float(plain.SliceThickness),
    ]
    affine = np.column_stack([*steps, np.array(plain.ImagePositionPatient, float)])
    for end in ("", "_RLE", "_bigendian", "_implicit", "_padded", "_jp2klossless", "_jpeg_ls_lossless"):
        check(plain.pixel_array.T[:, :, None], affine, os.path.join(folder, "MR_small%s.dcm" % end), kind=LABELS)


def test_damaged_compression_does_not_end_the_process():
    voxels = random_labels((6, 4), (0, 3))
    stream = io.BytesIO()
    Image.fromarray(voxels.T.astype("u1")).save(stream, "JPEG")
    two_bits = bytearray(stream.getvalue())
    two_bits[two_bits.index(b"\xff\xc0") + 4] = 2  # of each sample: GDCM aborts
    start_alone = b"\xff\x4f\xff\x51" + bytes(60)
    anything = np.random.default_rng(0).bytes(400)
    dataset = slice_of(voxels, (10, 20, 30))
    for syntax, damaged in (
        (JPEG2000Lossless, b"\0\0"),
        (JPEG2000Lossless, start_alone),
        (JPEG2000Lossless, anything),
        (JPEGBaseline8Bit, bytes(two_bits)),
    ):
        dataset.PixelData = encapsulate([damaged])
        dataset["PixelData"].is_undefined_length = True
        refused(FORMAT, "compressed pixels", save(dataset, "damaged.dcm", syntax))


def test_signals_while_pixels_are_decoded():
    """More pixels than a pipe holds, so that the decoding process waits; its caller's handlers interrupt it."""
    voxels = np.zeros((2048, 2048, 1), int)
    voxels[1000:1500, 300:900] = 7
    stream = io.BytesIO()
    Image.fromarray(voxels[:, :, 0].T.astype("u1")).save(stream, "JPEG2000", no_jp2=True, irreversible=False)
    dataset = slice_of(voxels[:, :, 0], (10, 20, 30))
    set_pixels(dataset, voxels[:, :, 0].T[None], bits=8)
    dataset.PixelData = encapsulate([stream.getvalue()])
    dataset["PixelData"].is_undefined_length = True
    name = save(dataset, "large.dcm", JPEG2000Lossless)
    os.environ["DISTURBED"] = "1"
    try:
        _, _, labels, centres = volume_reading.read(name)
    finally:
        del os.environ["DISTURBED"]
    assert labels.tolist() == [0, 7] and (centres == voxels).all()


VOXELS = random_labels((6, 4, 3), (0, 3, 900))
END_OF_SEQUENCE = struct.pack("<HHI", 0xFFFE, 0xE0DD, 0)


def volume_of_frames(syntax=ExplicitVRLittleEndian):
    frames = VOXELS.transpose(2, 1, 0)
    dataset = frames_dataset(ENHANCED_CT, frames, [(10, 20, 30 + 3 * k) for k in range(3)])
    if syntax == ExplicitVRBigEndian:
        dataset.PixelData = frames.astype(">u2").tobytes()
    return dataset


def bytes_of(dataset, implicit=False, little=True):
    stream = DicomBytesIO()
    stream.is_implicit_VR, stream.is_little_endian = implicit, little
    write_dataset(stream, dataset)
    return stream.getvalue()


def leave_lengths_open(dataset, sequences=True, items=True):
    for element in dataset:
        if element.VR == "SQ":
            element.is_undefined_length = sequences
            for inner in element.value:
                inner.is_undefined_length_sequence_item = items
                leave_lengths_open(inner, sequences, items)


def test_undefined_lengths():
    """Of sequences and of items, in each other; most scanners write so."""
    for syntax in (ExplicitVRLittleEndian, ImplicitVRLittleEndian, ExplicitVRBigEndian, DeflatedExplicitVRLittleEndian):
        for sequences, items in ((0, 0), (0, 1), (1, 0), (1, 1)):
            dataset = volume_of_frames(syntax)
            leave_lengths_open(dataset, bool(sequences), bool(items))
            name = save(dataset, "open.dcm", syntax)
            if syntax != DeflatedExplicitVRLittleEndian:
                open_lengths = open(name, "rb").read().count(b"\xff\xff\xff\xff")
                assert open_lengths == 7 * sequences + 9 * items, open_lengths
            check(VOXELS, AFFINE, name)


def nested(depth):
    """So many sequences in each other, of undefined lengths."""
    dataset = item(TextValue="the deepest")
    for _ in range(depth):
        dataset = item(ContentSequence=[dataset])
    leave_lengths_open(dataset)
    return dataset


def test_depth():
    for syntax in (ExplicitVRLittleEndian, ImplicitVRLittleEndian):
        dataset = volume_of_frames()
        dataset.ContentSequence = nested(12).ContentSequence
        leave_lengths_open(dataset)
        check(VOXELS, AFFINE, save(dataset, "deep.dcm", syntax))
        dataset.ContentSequence = nested(20).ContentSequence
        leave_lengths_open(dataset)
        refused(FORMAT, "its sequences are nested too deep", save(dataset, "deep.dcm", syntax))


def as_unknown(element, defined, little):
    """The sequence as an element of type UN, whose items have no types and are little-endian in all files."""
    items = bytes_of(element, implicit=True)[8:]
    if element[0x52009229].is_undefined_length:
        assert items.endswith(END_OF_SEQUENCE)
        items = items[: -len(END_OF_SEQUENCE)]
    length = len(items) if defined else 0xFFFFFFFF
    order = "<" if little else ">"
    head = struct.pack(order + "HH2sHI", 0x5200, 0x9229, b"UN", 0, length)
    return head + items + (b"" if defined else END_OF_SEQUENCE)


def test_sequences_of_unknown_type():
    for little in 1, 0:
        syntax = ExplicitVRLittleEndian if little else ExplicitVRBigEndian
        for open_inside in 0, 1:
            dataset = volume_of_frames(syntax)
            leave_lengths_open(dataset, bool(open_inside), bool(open_inside))
            shared = item(SharedFunctionalGroupsSequence=dataset.SharedFunctionalGroupsSequence)
            leave_lengths_open(shared, bool(open_inside), bool(open_inside))
            data = open(save(dataset, "known.dcm", syntax), "rb").read()
            known = bytes_of(shared, little=bool(little))
            assert data.count(known) == 1
            for defined in 0, 1:
                name = write("unknown.dcm", data.replace(known, as_unknown(shared, defined, little)))
                check(VOXELS, AFFINE, name)
                if little and not defined:
                    groups = pydicom.dcmread(name).SharedFunctionalGroupsSequence
                    assert groups[0].PixelMeasuresSequence[0].PixelSpacing == [0.5, 0.25]
    private = struct.pack("<HH2sHI", 9, 0x1001, b"UN", 0, 0xFFFFFFFF)
    private += struct.pack("<HHI", 0xFFFE, 0xE000, 0xFFFFFFFF) + bytes_of(nested(3), implicit=True)
    private += struct.pack("<HHI", 0xFFFE, 0xE00D, 0) + END_OF_SEQUENCE
    data = open(save(volume_of_frames(), "known.dcm"), "rb").read()
    place = data.index(struct.pack("<HH", 0x28, 2) + b"US")
    check(VOXELS, AFFINE, write("private.dcm", data[:place] + private + data[place:]))


def test_damaged_sequences():
    dataset = volume_of_frames()
    leave_lengths_open(dataset, items=False)
    data = open(save(dataset, "open.dcm"), "rb").read()
    end = data.rindex(END_OF_SEQUENCE)
    refused(FORMAT, "a sequence has no end", write("d.dcm", data[:end] + b"\x10\0\x10\0LO\0\0" + data[end + 8 :]))
    refused(FORMAT, "goes beyond the end of the file", write("d.dcm", data[:end]))
    stray = struct.pack("<HHI", 0xFFFE, 0xE000, 0)
    refused(FORMAT, "an item stands outside of a sequence", write("d.dcm", data[: end + 8] + stray + data[end + 8 :]))
    data = open(save(volume_of_frames(), "closed.dcm"), "rb").read()
    place = data.index(struct.pack("<HH2s", 0x5200, 0x9229, b"SQ")) + 12
    no_item = data[:place] + b"\x10\0\x10\0LO\0\0" + data[place + 8 :]
    refused(FORMAT, "the sequence (5200,9229) holds what is no item", write("d.dcm", no_item))
    end = data.index(struct.pack("<HH2s", 0x7FE0, 0x10, b"OW"))
    refused(FORMAT, "holds no image", write("d.dcm", data[:end]))


def test_deflated():
    """One value alone deflates to a thousandth."""
    plain = np.full((400, 500, 1), 3)
    dataset = slice_of(plain[:, :, 0], (10, 20, 30))
    name = save(dataset, "plain.dcm", DeflatedExplicitVRLittleEndian)
    assert os.path.getsize(name) < 2000
    alone = AFFINE.copy()
    alone[2, 2] = 1
    check(plain, alone, name)
    data = open(name, "rb").read()
    for damaged in (data[:-9], data[: len(data) // 2]):
        refused(FORMAT, "its deflated data cannot be unpacked", write("d.dcm", damaged))


def test_types_of_pixels():
    alone = AFFINE.copy()
    alone[2, 2] = 1
    for order, syntax in (("<", ExplicitVRLittleEndian), (">", ExplicitVRBigEndian), ("<", ImplicitVRLittleEndian)):
        for bits, signed, values in (
            (8, False, (0, 5, 255)),
            (8, True, (-128, 0, 127)),
            (16, False, (0, 258, 65535)),
            (16, True, (-32768, -2, 258)),
            (32, False, (0, 0x01020304, 2**31 - 1)),
            (32, True, (-(2**31), -5, 0x01020304)),
        ):
            voxels = random_labels((6, 4, 1), values)
            dataset = slice_of(voxels[:, :, 0], (10, 20, 30))
            set_pixels(dataset, voxels.transpose(2, 1, 0), bits, signed)
            dataset.PixelData = voxels.T.astype("%s%s%d" % (order, "iu"[not signed], bits // 8)).tobytes()
            dataset["PixelData"].VR = "OB" if bits == 8 else "OW"
            name = save(dataset, "t.dcm", syntax)
            if order == "<":
                assert (pydicom.dcmread(name).pixel_array.T[:, :, None] == voxels).all()
            check(voxels, alone, name, kind=LABELS)
        for keyword, bits in (("FloatPixelData", 32), ("DoubleFloatPixelData", 64)):
            dataset = slice_of(VOXELS[:, :, 0], (10, 20, 30))
            del dataset.PixelData, dataset.BitsStored, dataset.HighBit, dataset.PixelRepresentation
            dataset.BitsAllocated = bits
            setattr(dataset, keyword, VOXELS[:, :, 0].T.astype("%sf%d" % (order, bits // 8)).tobytes())
            check(VOXELS[:, :, :1], alone, save(dataset, "f.dcm", syntax))
    dataset = slice_of(VOXELS[:, :, 0], (10, 20, 30))
    dataset.BitsAllocated = 24
    refused(FORMAT, "its pixels have 24 bits, which cannot be read", save(dataset, "t.dcm"))
    del dataset.BitsStored, dataset.HighBit
    dataset.BitsAllocated, dataset.Rows = 16, 0
    refused(FORMAT, "how many rows, columns and frames", save(dataset, "t.dcm"))


def runs(planes, head=None):
    """A frame packed by run lengths: the bytes of its planes, the high ones first."""
    starts = 64 + np.cumsum([0] + [len(plane) for plane in planes])
    numbers = [len(planes), *starts[:-1]] if head is None else head
    return struct.pack("<16I", *numbers, *[0] * (16 - len(numbers))) + b"".join(planes)


def test_runs():
    voxels = random_labels((6, 4, 2), (0, 3, 900))
    dataset = frames_dataset(ENHANCED_CT, voxels.transpose(2, 1, 0), [(10, 20, 30), (10, 20, 33)])
    high, low = ((voxels[:, :, 0].T >> shift & 255).astype("u1").tobytes() for shift in (8, 0))
    literal = lambda plane: b"".join(bytes([11]) + plane[i : i + 12] for i in (0, 12))
    nothing = bytes([128])  # stands for no byte
    good = packed_by_runs(voxels[:, :, 1].T)
    first = runs([nothing + literal(high) + nothing, literal(low)])

    def packed(*frames):
        dataset.PixelData = encapsulate(list(frames))
        dataset["PixelData"].is_undefined_length = True
        return save(dataset, "runs.dcm", RLELossless)

    name = packed(first, good)
    check(voxels, AFFINE, name)
    assert (pydicom.dcmread(name).pixel_array == voxels.transpose(2, 1, 0)).all()
    for damaged, words in (
        (runs([literal(high), literal(low)[:-3]]), "its packed pixels end too early"),
        (runs([literal(high), literal(low)[:13]]), "its packed pixels end too early"),
        (runs([literal(high), literal(low), b""]), "its packed pixels have 3 planes of bytes"),
        (runs([literal(high), literal(low)], [2, 64, 999]), "a plane of its packed pixels lies beyond them"),
        (first[:60], "its packed pixels have no head"),
    ):
        refused(FORMAT, words, packed(damaged, good))
    refused(FORMAT, "its packed pixels are not one piece a frame", packed(first[:70], first[70:], good))
    dataset.Rows = dataset.Columns = 4000
    refused(FORMAT, "bytes, too few for 64000000", packed(first, good))


run_tests(globals())
