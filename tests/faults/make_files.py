"""Writes one small volume in each format that is read into a folder: make_files.py FOLDER."""
import gzip
import os
import struct
import sys

import numpy as np
import nibabel
import pydicom
import tifffile
from PIL import Image
from pydicom.dataset import Dataset, FileMetaDataset
from pydicom.uid import ExplicitVRLittleEndian, generate_uid

FOLDER = sys.argv[1]
VOXELS = np.zeros((4, 5, 6), np.uint8)  # [k, j, i]
VOXELS[1:3, 1:4, 1:4] = 7
VOXELS[2:, :, 4:] = 3


def path(name):
    return os.path.join(FOLDER, name)


def write(name, data):
    with open(path(name), "wb") as file:
        file.write(data)


def nrrd(encoding, data_file=None):
    head = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 6 5 4\nspacings: 1 1 2\nencoding: %s\n" % encoding
    return (head + ("data file: %s\n" % data_file if data_file else "\n")).encode()


def write_text_headers():
    raw = VOXELS.tobytes()
    write("raw.nrrd", nrrd("raw") + raw)
    write("gzip.nrrd", nrrd("gzip") + gzip.compress(raw))
    write("text.nrrd", nrrd("ascii") + " ".join(str(v) for v in raw).encode())
    write("voxels.raw", raw)
    write("apart.nhdr", nrrd("raw", "voxels.raw"))
    write(
        "voxels.mha",
        b"ObjectType = Image\nNDims = 3\nDimSize = 6 5 4\nElementType = MET_UCHAR\n" b"ElementDataFile = LOCAL\n" + raw,
    )
    write(
        "apart.mhd",
        b"ObjectType = Image\nNDims = 3\nDimSize = 6 5 4\nElementType = MET_UCHAR\n" b"ElementDataFile = voxels.raw\n",
    )
    write(
        "points.vtk",
        b"# vtk DataFile Version 3.0\nvoxels\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 6 5 4\n"
        b"ORIGIN 0 0 0\nSPACING 1 1 2\nPOINT_DATA 120\nSCALARS labels unsigned_char 1\nLOOKUP_TABLE default\n" + raw,
    )


def write_binary_headers():
    gipl = bytearray(256)
    struct.pack_into(">4HH4f", gipl, 0, 6, 5, 4, 1, 8, 1, 1, 2, 0)
    struct.pack_into(">I", gipl, 252, 719555000)
    write("voxels.gipl", bytes(gipl) + VOXELS.tobytes())
    write("voxels.gipl.gz", gzip.compress(bytes(gipl) + VOXELS.tobytes()))
    mrc = bytearray(1024)
    struct.pack_into("<4i", mrc, 0, 6, 5, 4, 0)
    struct.pack_into("<3i3f3f3i", mrc, 28, 6, 5, 4, 6, 5, 8, 90, 90, 90, 1, 2, 3)
    struct.pack_into("<i", mrc, 108, 20140)
    mrc[208:214] = b"MAP DD"
    write("voxels.mrc", bytes(mrc) + VOXELS.tobytes())


def write_by_others():
    image = np.ascontiguousarray(VOXELS.transpose(2, 1, 0))
    affine = np.diag([1.0, 1.0, 2.0, 1.0])
    for name in "voxels.nii", "voxels.nii.gz":
        nibabel.save(nibabel.Nifti1Image(image, affine), path(name))
    nibabel.save(nibabel.Nifti1Pair(image, affine), path("pair.hdr"))
    tifffile.imwrite(path("stack.tif"), VOXELS, photometric="minisblack")
    tifffile.imwrite(path("packed.tif"), VOXELS, photometric="minisblack", compression="zlib")
    for k, plane in enumerate(VOXELS):
        Image.fromarray(plane).save(path("slice%d.png" % k))
        Image.fromarray(plane).save(path("slice%d.bmp" % k))
    grey = np.full((4, 16, 16), 200, np.uint8)
    grey[2:] = 0
    for k, plane in enumerate(grey):
        Image.fromarray(plane).save(path("slice%d.jpg" % k), quality=100)


def write_series():
    os.mkdir(path("series"))
    series = generate_uid()
    for k, plane in enumerate(VOXELS):
        dataset = Dataset()
        dataset.file_meta = FileMetaDataset()
        dataset.file_meta.TransferSyntaxUID = ExplicitVRLittleEndian
        dataset.SOPClassUID = dataset.file_meta.MediaStorageSOPClassUID = "1.2.840.10008.5.1.4.1.1.2"
        dataset.SOPInstanceUID = dataset.file_meta.MediaStorageSOPInstanceUID = generate_uid()
        dataset.SeriesInstanceUID = series
        dataset.Modality, dataset.InstanceNumber = "CT", k + 1
        dataset.ImagePositionPatient, dataset.ImageOrientationPatient = [0, 0, 2 * k], [1, 0, 0, 0, 1, 0]
        dataset.PixelSpacing = [1, 1]
        dataset.SamplesPerPixel, dataset.PhotometricInterpretation = 1, "MONOCHROME2"
        dataset.Rows, dataset.Columns = plane.shape
        dataset.BitsAllocated = dataset.BitsStored = 16
        dataset.HighBit, dataset.PixelRepresentation = 15, 0
        dataset.PixelData = plane.astype("<u2").tobytes()
        dataset.is_little_endian, dataset.is_implicit_VR = True, False
        pydicom.dcmwrite(path("series/%d.dcm" % k), dataset, write_like_original=False)


write_text_headers()
write_binary_headers()
write_by_others()
write_series()
