"""make_corpus.py CLEFT FOLDER: writes the small valid files with which the fuzzers of readers begin.

Inputs that ever failed are beside them in the corpora, under names of their own; this script does not touch these.
"""
import base64
import gzip
import io
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

import h5py
import nibabel
import numpy as np
import pydicom
import tifffile
from PIL import Image
from pydicom.dataset import Dataset, FileDataset
from pydicom.encaps import encapsulate
from pydicom.uid import ExplicitVRLittleEndian, ImplicitVRLittleEndian, RLELossless

CLEFT, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
BORDER = b"\n--next file--\n"

LABELS = np.arange(24, dtype=np.uint8).reshape(4, 3, 2) % 3  # [z, y, x], as files have it
FUNCTION = np.linspace(-1, 1, 24, dtype="<f4").reshape(4, 3, 2)

MEDIT = """MeshVersionFormatted 2
Dimension 3
Vertices
5
0 0 0 0
1 0 0 0
0 1 0 0
0 0 1 0
1 1 1 0
Tetrahedra
2
1 2 3 4 3
2 5 3 4 7
Triangles
1
2 3 4 5
End
"""


def put(target, name, *parts):
    path = FOLDER / target / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(BORDER.join(part.encode() if isinstance(part, str) else part for part in parts))


# ---- meshes


def vtu(kind, data):
    """Two tetrahedra whose arrays are `data(array)` in the XML, of the given format."""
    arrays = [
        ("Points", "Float64", 3, [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1]),
        ("connectivity", "Int32", 1, [0, 1, 2, 3, 1, 4, 2, 3]),
        ("offsets", "Int32", 1, [4, 8]),
        ("types", "UInt8", 1, [10, 10]),
        ("material", "Int32", 1, [3, 7]),
    ]
    element = {
        name: '<DataArray Name="%s" type="%s" NumberOfComponents="%d" format="%s">%s</DataArray>'
        % (name, type_, width, kind, data(np.array(values, type_.lower())))
        for name, type_, width, values in arrays
    }
    compressor = ' compressor="vtkZLibDataCompressor"' if kind == "binary" else ""
    return (
        '<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian"'
        ' header_type="UInt32"%s><UnstructuredGrid><Piece NumberOfPoints="5" NumberOfCells="2"><Points>%s</Points>'
        "<Cells>%s%s%s</Cells><CellData>%s</CellData></Piece></UnstructuredGrid></VTKFile>\n"
    ) % (
        compressor,
        element["Points"],
        element["connectivity"],
        element["offsets"],
        element["types"],
        element["material"],
    )


def piece(numbers):
    """The same with numbers of points in the whole mesh, as a piece of it."""
    data = '<PointData><DataArray Name="GlobalPointIds" type="Int64" format="ascii">%s</DataArray></PointData>'
    text = vtu("ascii", lambda array: " ".join(map(str, array.tolist())))
    return text.replace("<Cells>", data % numbers + "<Cells>") if numbers else text


PIECES = (
    '<?xml version="1.0"?>\n<VTKFile type="PUnstructuredGrid" version="1.0"><PUnstructuredGrid GhostLevel="0">'
    '<Piece Source="given0.vtu"/><Piece Source="given1.vtu"/></PUnstructuredGrid></VTKFile>\n'
)


def base64_blocks(array):
    import base64

    packed = zlib.compress(array.tobytes())
    head = struct.pack("<4I", 1, array.nbytes, array.nbytes, len(packed))
    return (base64.b64encode(head) + base64.b64encode(packed)).decode()


def vtkhdf(libver, **options):
    """Two tetrahedra in one partition, in a version of HDF5."""
    bytes_ = io.BytesIO()
    with h5py.File(bytes_, "w", libver=libver) as file:
        grid = file.create_group("VTKHDF")
        grid.attrs["Type"] = np.bytes_("UnstructuredGrid")
        grid.attrs["Version"] = np.array([1, 0])
        for name, values in (("Points", 5), ("Cells", 2), ("ConnectivityIds", 8)):
            grid.create_dataset("NumberOf" + name, data=np.array([values]))
        points = np.array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1], "<f8").reshape(5, 3)
        grid.create_dataset("Points", data=points, **options)
        grid.create_dataset("Connectivity", data=np.array([0, 1, 2, 3, 1, 4, 2, 3]), **options)
        grid.create_dataset("Offsets", data=np.array([0, 4, 8]), **options)
        grid.create_dataset("Types", data=np.array([10, 10], "u1"), **options)
        grid.create_dataset("CellData/material", data=np.array([3, 7], "<i4"), **options)
    return bytes_.getvalue()


def binary_msh22():
    numbers = lambda *values: np.array(values, "<i4").tobytes()
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]
    nodes = b"".join(numbers(i + 1) + struct.pack("<3d", *p) for i, p in enumerate(points))
    tets = numbers(4, 2, 2, 1, 3, 3, 1, 2, 3, 4, 2, 7, 7, 2, 5, 3, 4)
    return (
        b"$MeshFormat\n2.2 1 8\n" + numbers(1) + b'\n$EndMeshFormat\n$PhysicalNames\n1\n3 3 "bone"\n'
        b"$EndPhysicalNames\n$Nodes\n5\n" + nodes + b"\n$EndNodes\n$Elements\n2\n" + tets + b"\n$EndElements\n"
    )


def make_meshes():
    with tempfile.TemporaryDirectory() as folder:
        given = os.path.join(folder, "given.mesh")
        pathlib.Path(given).write_text(MEDIT)

        def converted(name, *options):
            out = os.path.join(folder, name)
            subprocess.run([CLEFT, "convert", given, out, *options], check=True, stdout=subprocess.DEVNULL)
            return pathlib.Path(out)

        put("mesh_mesh", "two-tets", MEDIT)
        put("mesh_vtu", "appended", converted("a.vtu").read_bytes())
        put("mesh_vtu", "text", vtu("ascii", lambda array: " ".join(map(str, array.tolist()))))
        put("mesh_vtu", "base64", vtu("binary", base64_blocks))
        put("mesh_pvtu", "numbers", PIECES, piece("0 1 2 3 4"), piece("5 6 7 8 9"))
        put("mesh_pvtu", "places", PIECES, piece(""), piece(""))
        put("mesh_vtkhdf", "tables", vtkhdf("earliest"))
        put("mesh_vtkhdf", "links", vtkhdf(("v108", "v108")))
        put("mesh_vtkhdf", "packed", vtkhdf("earliest", chunks=True, compression="gzip", shuffle=True))
        put("mesh_vtk", "text", converted("a.vtk").read_bytes())
        put("mesh_msh", "41-binary", converted("a.msh").read_bytes())
        put("mesh_msh", "22-text", converted("b.msh", "--msh-version", "2.2").read_bytes())
        put("mesh_msh", "22-binary", binary_msh22())
        converted("t.node")
        put("mesh_tetgen", "two-tets", *(pathlib.Path(folder, "t" + end).read_bytes() for end in (".node", ".ele")))
    put(
        "mesh_msh",
        "41-text",
        """$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
1
3 3 "bone"
$EndPhysicalNames
$Entities
0 0 0 2
1 0 0 0 1 1 1 1 3 0
2 0 0 0 1 1 1 0 0
$EndEntities
$Nodes
1 5 1 5
3 1 0 5
1
2
3
4
5
0 0 0
1 0 0
0 1 0
0 0 1
1 1 1
$EndNodes
$Elements
2 2 1 2
3 1 4 1
1 1 2 3 4
3 2 4 1
2 2 5 3 4
$EndElements
""",
    )


# ---- volumes with headers of text


def nrrd(fields="", type_="uint8", encoding="raw", endian="little"):
    return (
        "NRRD0005\n# made by a script\ntype: %s\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 3 4\n"
        "space directions: (1,0,0) (0,2,0) (0,0,0.5)\nkinds: domain domain domain\nendian: %s\nencoding: %s\n"
        "space origin: (1,2,3)\n%s" % (type_, endian, encoding, fields)
    ).encode()


def make_nrrd():
    raw = LABELS.tobytes()
    put("volume_nrrd", "raw", nrrd() + b"\n" + raw)
    put("volume_nrrd", "gzip", nrrd(encoding="gzip") + b"\n" + gzip.compress(raw, mtime=0))
    put("volume_nrrd", "text", nrrd(encoding="text") + b"\n" + " ".join(map(str, LABELS.ravel())).encode())
    put("volume_nrrd", "hex", nrrd(encoding="hex") + b"\n" + raw.hex().encode())
    put("volume_nrrd", "float", nrrd(type_="float") + b"\n" + FUNCTION.tobytes())
    put("volume_nrrd", "big-endian", nrrd(type_="int16", endian="big") + b"\n" + LABELS.astype(">i2").tobytes())
    put("volume_nrrd", "detached", nrrd("data file: given.raw\nbyte skip: 2\nline skip: 1\n"), b"one\n.." + raw)
    put("volume_nrrd", "list", nrrd("data file: LIST 3\ngiven.raw\n"), raw)
    put("volume_nrrd", "numbered", nrrd("data file: given%d.raw 1 1 1\n"), b"", raw)
    put(
        "volume_nrrd",
        "spacings",
        b"NRRD0001\ntype: double\ndimension: 4\nsizes: 2 2 3 2\nspacings: nan 1 2 3\n"
        b"axis mins: nan 0 0 0\naxis maxs: nan 2 6 3\ncenters: none cell cell node\nkinds: list domain domain domain\n"
        b"endian: little\nencoding: raw\n\n" + FUNCTION.astype("<f8").tobytes(),
    )
    segments = "".join(
        "Segment%d_%s:=%s\n" % (i, key, value)
        for i in (0, 1)
        for key, value in [
            ("ID", "Segment_%d" % i),
            ("Name", "bone %d" % i),
            ("LabelValue", i + 1),
            ("Layer", 0),
            ("Extent", "0 1 0 2 0 3"),
            ("Color", "0.5 0.5 0.5"),
        ]
    )
    put(
        "volume_nrrd", "segments", nrrd("Segmentation_MasterRepresentation:=Binary labelmap\n" + segments) + b"\n" + raw
    )
    layers = segments.replace("Segment1_Layer:=0", "Segment1_Layer:=1")
    put(
        "volume_nrrd",
        "layers",
        b"NRRD0004\ntype: uint8\ndimension: 4\nspace: left-posterior-superior\n"
        b"sizes: 2 2 3 2\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\nkinds: list domain domain domain\n"
        b"encoding: raw\nspace origin: (0,0,0)\n"
        + layers.encode()
        + b"\n"
        + np.stack([LABELS.ravel()[:12] % 2, LABELS.ravel()[:12] // 2 * 2], 1).astype("u1").tobytes(),
    )


def make_metaimage():
    head = (
        "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n%s"
        "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 1 2 3\nCenterOfRotation = 0 0 0\nAnatomicalOrientation = RAI\n"
        "ElementSpacing = 1 2 0.5\nDimSize = 2 3 4\nElementType = %s\nElementDataFile = %s\n"
    )
    raw = LABELS.tobytes()
    packed = zlib.compress(raw)
    put("volume_metaimage", "local", (head % ("", "MET_UCHAR", "LOCAL")).encode() + raw)
    put("volume_metaimage", "float", (head % ("", "MET_FLOAT", "LOCAL")).encode() + FUNCTION.tobytes())
    put(
        "volume_metaimage",
        "compressed",
        (head % ("CompressedData = True\nCompressedDataSize = %d\n" % len(packed), "MET_UCHAR", "LOCAL")).encode()
        + packed,
    )
    put("volume_metaimage", "detached", head % ("HeaderSize = -1\n", "MET_UCHAR", "given.raw"), raw)
    put("volume_metaimage", "list", head % ("", "MET_UCHAR", "LIST 3\ngiven.raw"), raw)
    put("volume_metaimage", "pattern", head % ("", "MET_UCHAR", "given%d.raw 1 1 1"), b"", raw)
    put(
        "volume_metaimage",
        "text",
        head.replace("BinaryData = True", "BinaryData = False") % ("", "MET_SHORT", "LOCAL")
        + " ".join(map(str, LABELS.ravel())),
    )


def make_vtk():
    head = (
        "# vtk DataFile Version 3.0\nmade by a script\n%s\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 3 4\n"
        "SPACING 1 2 0.5\nORIGIN 1 2 3\n%s_DATA %d\n"
    )
    text = " ".join(map(str, LABELS.ravel()))
    put("volume_vtk", "text", head % ("ASCII", "POINT", 24) + "SCALARS labels int 1\nLOOKUP_TABLE default\n" + text)
    put(
        "volume_vtk",
        "binary",
        (head % ("BINARY", "POINT", 24) + "SCALARS a float\nLOOKUP_TABLE default\n").encode()
        + FUNCTION.astype(">f4").tobytes(),
    )
    put(
        "volume_vtk",
        "cells",
        head % ("ASCII", "CELL", 6) + "FIELD FieldData 2\nlabels 1 6 int\n1 2 3 1 2 3\n"
        "other 1 6 long\n1 2 3 4 5 6\n",
    )
    put(
        "volume_vtk",
        "rectilinear",
        "# vtk DataFile Version 5.1\nt\nASCII\nDATASET RECTILINEAR_GRID\nDIMENSIONS 2 3 4\n"
        "X_COORDINATES 2 float\n0 1\nY_COORDINATES 3 double\n0 2 4\nZ_COORDINATES 4 int\n0 1 2 3\nPOINT_DATA 24\n"
        "SCALARS labels unsigned_char\nLOOKUP_TABLE default\n" + text,
    )


# ---- volumes with binary headers


def make_nifti():
    affine = np.array([[-1, 0, 0, 5], [0, 2, 0.1, 6], [0, -0.1, 0.5, 7], [0, 0, 0, 1]])

    def data_of(image):
        return image.to_bytes()

    labels = np.ascontiguousarray(LABELS.T)
    put("volume_nii", "sform", data_of(nibabel.Nifti1Image(labels, affine)))
    image = nibabel.Nifti1Image(FUNCTION.T, None)
    image.set_qform(np.diag([1, 2, 3, 1]), 1)
    put("volume_nii", "qform", data_of(image))
    put("volume_nii", "version2", data_of(nibabel.Nifti2Image(labels.astype("i2"), affine)))
    put("volume_nii", "gzip", gzip.compress(data_of(nibabel.Nifti1Image(labels, affine)), mtime=0))
    image = nibabel.Nifti1Image(np.stack([FUNCTION.T, -FUNCTION.T], 3), affine)
    put("volume_nii", "frames", data_of(image))
    scaled = nibabel.Nifti1Image(labels.astype("i2"), affine)
    scaled.header.set_slope_inter(2, -1)
    put("volume_nii", "scaled", data_of(scaled))
    big = nibabel.Nifti1Image(labels.astype(">i2"), affine, nibabel.Nifti1Header(endianness=">"))
    put("volume_nii", "big-endian", data_of(big))
    pair = nibabel.Nifti1Pair(labels, affine)
    files = {"header": io.BytesIO(), "image": io.BytesIO()}
    pair.to_file_map({name: nibabel.FileHolder(fileobj=file) for name, file in files.items()})
    put("volume_analyze", "pair", *(file.getvalue() for file in files.values()))
    analyze = nibabel.AnalyzeImage(labels.astype("i2"), np.eye(4))
    files = {"header": io.BytesIO(), "image": io.BytesIO()}
    analyze.to_file_map({name: nibabel.FileHolder(fileobj=file) for name, file in files.items()})
    put("volume_analyze", "analyze75", *(file.getvalue() for file in files.values()))


def picture(format_, image, **keywords):
    file = io.BytesIO()
    image.save(file, format_, **keywords)
    return file.getvalue()


def make_tiff():
    def tiff(data, **keywords):
        file = io.BytesIO()
        tifffile.imwrite(file, data, **keywords)
        return file.getvalue()

    put("volume_tif", "plain", tiff(LABELS, photometric="minisblack", metadata=None))
    put(
        "volume_tif",
        "imagej",
        tiff(LABELS.astype("u2"), imagej=True, resolution=(2, 2), metadata={"axes": "ZYX", "spacing": 3, "unit": "um"}),
    )
    put("volume_tif", "deflate", tiff(LABELS, compression="zlib", predictor=True, photometric="minisblack"))
    for name in ("lzw", "packbits", "jpeg"):
        put(
            "volume_tif",
            name,
            picture("TIFF", Image.fromarray(LABELS[0]), compression=name if name != "lzw" else "tiff_lzw"),
        )
    put("volume_tif", "ccitt", picture("TIFF", Image.fromarray(LABELS[0] > 1), compression="group4"))
    put("volume_tif", "big", tiff(LABELS, bigtiff=True, photometric="minisblack", metadata=None))
    put("volume_tif", "tiles", tiff(np.tile(LABELS[0], (8, 8)), tile=(16, 16), photometric="minisblack", metadata=None))
    put("volume_tif", "big-endian", tiff(LABELS.astype(">i4"), byteorder=">", photometric="minisblack", metadata=None))
    put("volume_tif", "bits", tiff(LABELS[0] > 1, photometric="minisblack", metadata=None))
    put("volume_tif", "float", tiff(FUNCTION, photometric="minisblack", metadata=None))
    put(
        "volume_tif",
        "ome",
        tiff(
            LABELS,
            ome=True,
            photometric="minisblack",
            metadata={"axes": "ZYX", "PhysicalSizeX": 1, "PhysicalSizeY": 2, "PhysicalSizeZ": 3},
        ),
    )


def make_pictures():
    grey = Image.fromarray(LABELS[0])
    palette = grey.convert("P")
    for format_, target in (("PNG", "volume_png"), ("BMP", "volume_bmp"), ("JPEG", "volume_jpg")):
        put(target, "grey", picture(format_, grey))
        put(target, "colours", picture(format_, grey.convert("RGB")))
        if format_ != "JPEG":
            put(target, "palette", picture(format_, palette))
            put(target, "bits", picture(format_, Image.fromarray(LABELS[0] > 1)))
    put("volume_png", "deep", picture("PNG", Image.fromarray(LABELS[0].astype("u2") * 1000)))
    put("volume_jpg", "progressive", picture("JPEG", grey, progressive=True))


def make_gipl_and_mrc():
    header = bytearray(256)
    struct.pack_into(">4H", header, 0, 2, 3, 4, 1)
    struct.pack_into(">H", header, 8, 8)  # unsigned bytes
    struct.pack_into(">4f", header, 10, 1, 2, 0.5, 1)
    struct.pack_into(">4d", header, 204, 1, 2, 3, 0)
    struct.pack_into(">I", header, 252, 719555000)
    put("volume_gipl", "bytes", bytes(header) + LABELS.tobytes())
    put("volume_gipl", "gzip", gzip.compress(bytes(header) + LABELS.tobytes(), mtime=0))
    struct.pack_into(">H", header, 8, 64)
    put("volume_gipl", "float", bytes(header) + FUNCTION.astype(">f4").tobytes())
    for name, mode, data in (("bytes", 0, LABELS), ("short", 1, LABELS.astype("<i2")), ("float", 2, FUNCTION)):
        header = bytearray(1024)
        struct.pack_into("<10i", header, 0, 2, 3, 4, mode, 0, 0, 0, 2, 3, 4)
        struct.pack_into("<6f", header, 40, 2, 6, 2, 90, 90, 90)
        struct.pack_into("<3i", header, 64, 1, 2, 3)
        header[208:216] = b"MAP \x44\x44\0\0"
        put("volume_mrc", name, bytes(header) + data.tobytes())


# ---- DICOM


def slice_of(number, syntax=ExplicitVRLittleEndian):
    uid = "1.2.826.0.1.3680043.8.498.1"
    meta = pydicom.dataset.FileMetaDataset()
    meta.MediaStorageSOPClassUID = "1.2.840.10008.5.1.4.1.1.2"
    meta.MediaStorageSOPInstanceUID = uid + ".%d" % number
    meta.TransferSyntaxUID = syntax
    file = FileDataset("", {}, file_meta=meta, preamble=bytes(128))
    file.SOPClassUID, file.SOPInstanceUID = meta.MediaStorageSOPClassUID, meta.MediaStorageSOPInstanceUID
    file.Modality, file.SeriesInstanceUID, file.InstanceNumber = "CT", uid, number
    file.ImagePositionPatient, file.ImageOrientationPatient = [1, 2, 3 * number], [1, 0, 0, 0, 1, 0]
    file.PixelSpacing, file.SliceThickness = [2, 1], 3
    file.Rows, file.Columns, file.SamplesPerPixel, file.PhotometricInterpretation = 3, 2, 1, "MONOCHROME2"
    file.BitsAllocated, file.BitsStored, file.HighBit, file.PixelRepresentation = 16, 12, 11, 0
    file.RescaleSlope, file.RescaleIntercept = 1, 0
    file.PixelData = LABELS[number].astype("<u2").tobytes()
    file["PixelData"].VR = "OW"
    return file


def dicom_bytes(file):
    out = io.BytesIO()
    file.is_little_endian, file.is_implicit_VR = True, file.file_meta.TransferSyntaxUID == ImplicitVRLittleEndian
    file.save_as(out, write_like_original=False)
    return out.getvalue()


def sequence_of(**fields):
    item = Dataset()
    for name, value in fields.items():
        setattr(item, name, value)
    return [item]


def frame_at(z, segment=None):
    item = Dataset()
    item.PlanePositionSequence = sequence_of(ImagePositionPatient=[0, 0, z])
    if segment:
        item.SegmentIdentificationSequence = sequence_of(ReferencedSegmentNumber=segment)
    return item


def of_frames(class_uid, frames):
    file = slice_of(0)
    file.SOPClassUID = file.file_meta.MediaStorageSOPClassUID = class_uid
    for name in (
        "ImagePositionPatient",
        "ImageOrientationPatient",
        "PixelSpacing",
        "SliceThickness",
        "RescaleSlope",
        "RescaleIntercept",
    ):
        delattr(file, name)
    file.NumberOfFrames = len(frames)
    shared = Dataset()
    shared.PlaneOrientationSequence = sequence_of(ImageOrientationPatient=[1, 0, 0, 0, 1, 0])
    shared.PixelMeasuresSequence = sequence_of(PixelSpacing=[2, 1], SliceThickness=3)
    file.SharedFunctionalGroupsSequence, file.PerFrameFunctionalGroupsSequence = [shared], frames
    return file


def make_dicom():
    put("volume_dicom", "explicit", dicom_bytes(slice_of(0)))
    put("volume_dicom", "implicit", dicom_bytes(slice_of(0, ImplicitVRLittleEndian)))
    packed = slice_of(0)
    packed.compress(RLELossless)
    put("volume_dicom", "run-lengths", dicom_bytes(packed))
    # GDCM reads these, where it is built in.
    for name, syntax, format_ in (
        ("jpeg", "1.2.840.10008.1.2.4.50", "JPEG"),
        ("jpeg2000", "1.2.840.10008.1.2.4.90", "JPEG2000"),
    ):
        packed = slice_of(0, syntax)
        packed.BitsAllocated, packed.BitsStored, packed.HighBit = 8, 8, 7
        options = {"no_jp2": True} if format_ == "JPEG2000" else {}
        packed.PixelData = encapsulate([picture(format_, Image.fromarray(LABELS[0]), **options)])
        packed["PixelData"].VR = "OB"
        packed["PixelData"].is_undefined_length = True
        put("volume_dicom", name, dicom_bytes(packed))
    enhanced = of_frames("1.2.840.10008.5.1.4.1.1.2.1", [frame_at(3.0), frame_at(6.0)])
    enhanced.PixelData = LABELS[:2].astype("<u2").tobytes()
    put("volume_dicom", "frames", dicom_bytes(enhanced))
    segments = of_frames("1.2.840.10008.5.1.4.1.1.66.4", [frame_at(0.0, 1), frame_at(3.0, 2)])
    segments.Modality, segments.SegmentationType = "SEG", "BINARY"
    segments.BitsAllocated, segments.BitsStored, segments.HighBit = 1, 1, 0
    segments.SegmentSequence = [sequence_of(SegmentNumber=n, SegmentLabel="bone %d" % n)[0] for n in (1, 2)]
    segments.PixelData = b"\x55\x0a"
    put("volume_dicom", "segments", dicom_bytes(segments))
    put("volume_dicom_series", "three", *(dicom_bytes(slice_of(n)) for n in (2, 0, 1)))
    put("volume_dicom_series", "two-and-another", dicom_bytes(slice_of(0)), dicom_bytes(slice_of(1)), b"no DICOM")


# ---- what is no file


def make_bytes():
    random = np.random.default_rng(3)
    for target in ("meshing", "background"):
        for i in range(16):
            put(target, "random-%02d" % i, random.bytes(60 + 20 * i))
    for i in range(20):
        # The first bytes choose the size of bricks and the form of the points.
        put("points", "random-%02d" % i, bytes([i, i % 5, i // 5]) + random.bytes(60 + 40 * i))
    put(
        "options",
        "all",
        "background=octree\nsize=1.5\nsize_min=0.1\nsize-max=4\nfeature_scale=2e0\ngradation=.3\n"
        "interface_size=1\ntets=1000\nsmooth=5\nsnap=safe\nimprove=best\nsteps=3\nseed=7\nstrict=true\nrepair=30\n"
        "max_tets=0\nkeep_thin=0\n",
    )
    put(
        "options",
        "refused",
        "size=nan\nsize=-1\nsize=1e999\nsize=0x1p3\nsteps=1.5\nsteps=9999999999999999999999\n"
        "strict=yes\nsnap=1\nnone=1\nsize=1 \n=\nsize\n",
    )


def make_names():
    put("names", "plain", "# names\n0 air\n3, right lung\n-7=left lung\n2147483647;rest\n")
    put("names", "snap", '0 0 0 0 0 0 0 "Clear Label"\n 3 255 0 0 1 1 1 "right \\"lung"\n-7 0 255 0 0.5 1 1 ""\n')
    put("names", "freesurfer", "# LUT\n0 Unknown 0 0 0 0\n3   Right-Lung  10 20 30 0\n2147483647 Rest 1 2 3 0\n")
    put("names", "mricron", "3 Lung_R 2001\n-7 Lung_L 2002\n")
    put("names", "numbers", "3 Area 17\n-7 Area 18\n0 0\n")
    put("names", "windows", b"\xef\xbb\xbf3\tright\tlung\r\n\r\n-7\tgr\xc3\xb6\xc3\x9fer\r\n3 once more\r\n")
    put("names", "empty", "\n# 3 none\n")
    put("names", "refused", b"3 a\xff\n")
    put("names", "control", "3 a\x01b\n-7 c\n")
    put("names", "label", "99999999999 a\n3x b\n")


# Two voxels; xx xy xz yy yz zz in the order that each format has.
TENSORS = np.array([[2, 0.1, 0.2, 3, 0.3, 4], [1, 0, 0, 1, 0, 0.5]])
NINE, VTK_SIX, NIFTI_SIX = (0, 1, 2, 1, 3, 4, 2, 4, 5), (0, 3, 5, 1, 4, 2), (0, 1, 3, 2, 4, 5)


def vti(array, appended=""):
    return (
        '<?xml version="1.0"?>\n<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64"'
        '>\n<ImageData WholeExtent="0 1 0 0 0 0" Origin="1 2 3" Spacing="1 0.5 2" Direction="1 0 0 0 1 0 0 0 1">\n'
        f'<Piece Extent="0 1 0 0 0 0"><PointData>{array}</PointData><CellData/></Piece></ImageData>{appended}'
        "</VTKFile>\n"
    )


def make_metrics():
    text = {len(order): " ".join(map(str, TENSORS[:, order].ravel())) for order in (NINE, VTK_SIX)}
    head = '<DataArray type="Float64" Name="m" NumberOfComponents="%d" format="%s"%s>'
    put("metric_vti", "nine", vti(head % (9, "ascii", "") + text[9] + "</DataArray>"))
    put("metric_vti", "six", vti(head % (6, "ascii", "") + text[6] + "</DataArray>"))
    raw = TENSORS[:, NINE].astype("<f8").tobytes()
    whole = vti(
        head % (9, "appended", ' offset="0"') + "</DataArray>", '<AppendedData encoding="raw">_@</AppendedData>'
    )
    before, after = whole.encode().split(b"@")
    put("metric_vti", "raw", before + struct.pack("<Q", len(raw)) + raw + after)
    coded = base64.b64encode(struct.pack("<Q", len(raw)) + raw).decode()
    put("metric_vti", "base64", vti(head % (9, "binary", "") + coded + "</DataArray>"))
    grid = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 1 1\nORIGIN 0 0 0\n"
    grid += "SPACING 1 1 1\nPOINT_DATA 2\n"
    put("metric_vtk", "nine", f"{grid}TENSORS m double\n{text[9]}\n")
    put("metric_vtk", "six", f"{grid}TENSORS6 m double\n{text[6]}\n")
    nrrd = "NRRD0005\ntype: double\ndimension: 4\nencoding: text\nsizes: %d 2 1 1\nkinds: %s domain domain domain\n"
    frame = "space: RAS\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\nmeasurement frame: (0,1,0) (-1,0,0) (0,0,1)\n"
    six = "\n".join(" ".join(map(str, row)) for row in TENSORS.tolist())
    put("metric_nrrd", "six", nrrd % (6, "3D-symmetric-matrix") + frame + "\n" + six + "\n")
    put("metric_nrrd", "masked", nrrd % (7, "3D-masked-symmetric-matrix") + "\n1 " + six.replace("\n", "\n1 ") + "\n")
    put("metric_nrrd", "nine", nrrd % (9, "3D-matrix") + "\n" + text[9] + "\n")
    image = nibabel.Nifti1Image(TENSORS[:, NIFTI_SIX].reshape(2, 1, 1, 1, 6).astype("f4"), np.eye(4))
    image.header.set_intent("symmetric matrix", (3,))
    put("metric_nii", "six", image.to_bytes())


for make in (
    make_bytes,
    make_metrics,
    make_names,
    make_meshes,
    make_nrrd,
    make_metaimage,
    make_vtk,
    make_nifti,
    make_tiff,
    make_pictures,
    make_gipl_and_mrc,
    make_dicom,
):
    make()
