"""What the scripts that test the reading of DICOM share: files as pydicom writes them, the same in each run."""
import itertools
import struct

import numpy as np
import pydicom
from pydicom.dataset import Dataset, FileMetaDataset
from pydicom.sequence import Sequence
from pydicom.uid import ExplicitVRBigEndian, ExplicitVRLittleEndian, ImplicitVRLittleEndian

import volume_reading
from volume_reading import FILE, FORMAT, LABELS, path, run_dump, run_tests, write

UNSUPPORTED = -10

CT = "1.2.840.10008.5.1.4.1.1.2"
ENHANCED_CT = "1.2.840.10008.5.1.4.1.1.2.1"
SEGMENTATION = "1.2.840.10008.5.1.4.1.1.66.4"
LABEL_MAP = "1.2.840.10008.5.1.4.1.1.66.7"
RT_STRUCTURES = "1.2.840.10008.5.1.4.1.1.481.3"
INSTANCES = itertools.count(1)
TURNED = [0, 1, 0, 0, 0, -1]  # rows go to the back, columns to the feet


def check(voxels, affine, *paths, reported=(), **options):
    """The volume has these voxels at these places, and each of the words is reported: nothing if there are none."""
    volume_reading.check(voxels, affine, *paths, **options)
    output = run_dump(paths, **options)[0].stdout
    assert all(word in output for word in reported), output
    assert reported or "warning: " not in output, output


def refused(status, words, name, **options):
    for word in [words] if isinstance(words, str) else words:
        volume_reading.refused(status, word, name, **options)


def item(**values):
    dataset = Dataset()
    for name, value in values.items():
        setattr(dataset, name, value)
    return dataset


def group(**values):
    return Sequence([item(**values)])


def new(storage, **values):
    dataset = item(SOPClassUID=storage, SOPInstanceUID="1.2.8.%d" % next(INSTANCES), **values)
    dataset.file_meta = FileMetaDataset()
    dataset.file_meta.MediaStorageSOPClassUID = storage
    dataset.file_meta.MediaStorageSOPInstanceUID = dataset.SOPInstanceUID
    return dataset


def save(dataset, name, syntax=ExplicitVRLittleEndian):
    dataset.file_meta.TransferSyntaxUID = syntax
    dataset.is_little_endian = syntax != ExplicitVRBigEndian
    dataset.is_implicit_VR = syntax == ImplicitVRLittleEndian
    pydicom.dcmwrite(path(name), dataset, write_like_original=False)
    return path(name)


def set_pixels(dataset, frames, bits=16, signed=False):
    """`frames` as [frame, row, column]."""
    dataset.SamplesPerPixel, dataset.PhotometricInterpretation = 1, "MONOCHROME2"
    dataset.Rows, dataset.Columns = frames.shape[1:]
    dataset.BitsAllocated = dataset.BitsStored = bits
    dataset.HighBit, dataset.PixelRepresentation = bits - 1, int(signed)
    if len(frames) > 1 or bits == 1:
        dataset.NumberOfFrames = len(frames)
    if bits == 1:
        dataset.PixelData = np.packbits(frames.ravel() > 0, bitorder="little").tobytes()
    else:
        dataset.PixelData = frames.astype("<%s%d" % ("iu"[not signed], bits // 8)).tobytes()
    dataset.PixelData += b"\0" * (len(dataset.PixelData) % 2)


def slice_of(pixels, position, series="1.2.5", storage=CT, orientation=(1, 0, 0, 0, 1, 0), **values):
    """One slice; pixels as [column, row]."""
    dataset = new(
        storage,
        SeriesInstanceUID=series,
        ImagePositionPatient=list(position),
        ImageOrientationPatient=list(orientation),
        PixelSpacing=[0.5, 0.25],
        SliceThickness=1,
        **values,
    )
    set_pixels(dataset, pixels.T[None])
    return dataset


def random_labels(shape, values, seed=0):
    return np.random.default_rng(seed).choice(np.array(values), shape)


AFFINE = np.array([[0.25, 0, 0, 10], [0, 0.5, 0, 20], [0, 0, 3, 30]])


def packed_by_runs(frame):
    """One frame of 16 bits, high bytes first; runs of three or more as runs."""
    planes = []
    for plane in (frame >> 8, frame & 255):
        row, out = plane.astype("u1").tobytes(), bytearray()
        at = 0
        while at < len(row):
            end = at + 1
            while end < len(row) and row[end] == row[at] and end - at < 128:
                end += 1
            if end - at > 2:
                out += bytes([257 - (end - at), row[at]])
            else:
                end = at + 1
                out += bytes([0, row[at]])
            at = end
        planes.append(bytes(out) + b"\0" * (len(out) % 2))
    head = struct.pack("<16I", 2, 64, 64 + len(planes[0]), *[0] * 13)
    return head + planes[0] + planes[1]


def frames_dataset(storage, frames, positions, orientation=(1, 0, 0, 0, 1, 0), bits=16, measures=(0.5, 0.25, 3)):
    dataset = new(storage)
    set_pixels(dataset, frames, bits)
    measure = group(PixelSpacing=list(measures[:2]))
    if measures[2]:
        measure[0].SpacingBetweenSlices = measures[2]
    dataset.SharedFunctionalGroupsSequence = group(
        PlaneOrientationSequence=group(ImageOrientationPatient=list(orientation)), PixelMeasuresSequence=measure
    )
    dataset.PerFrameFunctionalGroupsSequence = Sequence(
        [item(PlanePositionSequence=group(ImagePositionPatient=[float(x) for x in p])) for p in positions]
    )
    return dataset
