"""DICOM: series, volumes of frames, segmentations; damaged files, and what holds no voxels. Files are written by
pydicom: check_dicom.py DUMP_VOLUME."""
import os

import numpy as np
from pydicom.encaps import encapsulate
from pydicom.sequence import Sequence
from pydicom.uid import (
    DeflatedExplicitVRLittleEndian,
    ExplicitVRLittleEndian,
    ImplicitVRLittleEndian,
    RLELossless,
)

from dicom_files import *


def write_series(folder, voxels, **values):
    os.makedirs(path(folder), exist_ok=True)
    for k in range(voxels.shape[2]):  # names in the other order than places
        save(
            slice_of(voxels[:, :, k], (10, 20, 30 + 3 * k), InstanceNumber=k, **values), "%s/%d.dcm" % (folder, 99 - k)
        )
    return path(folder)


def test_series():
    voxels = random_labels((6, 4, 5), (0, 3, 900))
    folder = write_series("series", voxels, SeriesDescription="Thorax")
    open(path("series/notes.txt"), "w").write("no DICOM")
    open(path("series/junk"), "wb").write(b"\x08\0\x05\0" + bytes(200))
    check(voxels, AFFINE, folder)
    for k in (0, 4):
        alone = AFFINE.copy()
        alone[2] = [0, 0, 1, 30 + 3 * k]  # a single file knows its thickness only
        check(voxels[:, :, k : k + 1], alone, path("series/%d.dcm" % (99 - k)))
    twice = slice_of(voxels[:, :, 0], (10, 20, 33), InstanceNumber=50)
    save(twice, "series/twice.dcm")
    refused(FORMAT, ["same place", "twice.dcm"], folder)
    os.remove(path("series/twice.dcm"))
    os.remove(path("series/97.dcm"))
    refused(FORMAT, "evenly spaced", folder)
    save(slice_of(voxels[:, :, 2], (10, 20, 36), series="1.2.6", SeriesDescription="Lung"), "series/97.dcm")
    refused(FILE, ["2:", "Thorax", "4 files", "UID 1.2.5", "Lung", "1 file of 6 x 4", "UID 1.2.6"], folder)
    os.mkdir(path("empty"))
    refused(FILE, "DICOM series", path("empty"))


def test_pattern_of_slices():
    voxels = random_labels((6, 4, 3), (0, 3, 900))
    for k in range(3):
        save(slice_of(voxels[:, :, k], (10, 20, 30 + 3 * k)), "p%d.dcm" % k)
        save(slice_of(voxels[:, :, k], (10, 20, 30)), "q%d.dcm" % k)
    check(voxels, AFFINE, path("p*.dcm"))
    refused(FORMAT, "its slices lie at the same place", path("q*.dcm"))


def test_series_without_places():
    voxels = random_labels((6, 4, 3), (0, 3, 9))
    os.makedirs(path("placeless"))
    for k in range(3):
        dataset = slice_of(voxels[:, :, k], (0, 0, 0), InstanceNumber=9 + k)
        del dataset.ImagePositionPatient
        save(dataset, "placeless/%d.dcm" % (3 - k))
    check(voxels, np.diag([0.25, 0.5, 1, 0])[:3], path("placeless"), reported=["order of their numbers"])
    dataset.InstanceNumber = 10
    save(dataset, "placeless/1.dcm")
    refused(FORMAT, "the same number", path("placeless"))


def test_rescaled():
    stored = random_labels((6, 4, 3), (0, 1, 2))
    check(2 * stored - 3, AFFINE, write_series("rescaled", stored, RescaleSlope=2, RescaleIntercept=-3))


def test_folders():
    """The only series of a tree is read; of several, all are named."""
    voxels = random_labels((6, 4, 3), (0, 3, 900))
    os.makedirs(path("tree/STUDY"))
    save(new("1.2.840.10008.1.3.10", FileSetID="CD"), "tree/DICOMDIR")
    write_series("tree/STUDY/SERIES1", voxels)
    for folder in "tree", "tree/", "tree/STUDY":
        check(voxels, AFFINE, path(folder))
    write_series("tree/STUDY/SERIES2", voxels)
    refused(FILE, ["STUDY/SERIES1", "STUDY/SERIES2", "2 folders"], path("tree"))
    check(voxels, AFFINE, path("tree/STUDY/SERIES1"))
    os.makedirs(path("pictures"))
    open(path("pictures/s1.TIF"), "wb").write(b"II*")
    refused(FILE, "*.TIF", path("pictures"))


def test_rounded_orientation():
    """Numbers that differ by rounding alone do not part a series."""
    voxels = random_labels((6, 4, 3), (0, 3, 900))
    folder = write_series("rounded", voxels)
    save(
        slice_of(voxels[:, :, 1], (10, 20, 33), orientation=(1, "-1.2e-09", 0, "0.0", "0.99999999", 0)),
        "rounded/98.dcm",
    )
    check(voxels, AFFINE, folder)


def test_doubts_are_told():
    voxels = random_labels((6, 4, 3), (0, 3, 900))
    check(voxels, AFFINE, write_series("lossy", voxels, LossyImageCompression="01"), reported=["changes values"])
    for k in range(3):
        dataset = slice_of(voxels[:, :, k], (10, 20, 30 + 3 * k))
        dataset.PhotometricInterpretation = "MONOCHROME1"
        dataset.ImagerPixelSpacing = dataset.PixelSpacing
        del dataset.PixelSpacing
        table = item(LUTDescriptor=[4, 0, 16], ModalityLUTType="US", LUTData=[0, 10, 20, 30])
        table["LUTDescriptor"].VR = table["LUTData"].VR = "US"
        dataset.ModalityLUTSequence = Sequence([table])
        os.makedirs(path("doubts"), exist_ok=True)
        save(dataset, "doubts/%d.dcm" % k)
    check(voxels, AFFINE, path("doubts"), reported=["MONOCHROME1", "at the detector", "Modality LUT"])


def test_volume_of_frames():
    voxels = random_labels((6, 4, 5), (0, 3, 900))
    order = [2, 0, 4, 1, 3]
    frames = np.array([voxels[:, :, k].T for k in order])
    positions = [(10, 20, 30 + 3 * k) for k in order]
    for syntax in (ExplicitVRLittleEndian, ImplicitVRLittleEndian):
        check(voxels, AFFINE, save(frames_dataset(ENHANCED_CT, frames, positions), "frames.dcm", syntax))
    over_time = frames_dataset(ENHANCED_CT, frames, [(10, 20, 30 + 3 * (k % 3)) for k in range(5)])
    refused(FORMAT, "over time", save(over_time, "time.dcm"))
    del over_time.PerFrameFunctionalGroupsSequence
    refused(FORMAT, "where they lie", save(over_time, "cine.dcm"))


def segmentation(frames, segments, names=("Liver", "Tumor"), kind="BINARY", **options):
    """`frames`: (segment, position, pixels as [column, row])."""
    dataset = frames_dataset(
        SEGMENTATION,
        np.array([pixels.T for _, _, pixels in frames]),
        [place for _, place, _ in frames],
        **{"bits": 1, **options},
    )
    dataset.SegmentationType = kind
    dataset.SegmentSequence = Sequence([item(SegmentNumber=n, SegmentLabel=name) for n, name in zip(segments, names)])
    for row, (segment, _, _) in zip(dataset.PerFrameFunctionalGroupsSequence, frames):
        row.SegmentIdentificationSequence = group(ReferencedSegmentNumber=segment)
    return dataset


def segment_frames(voxels, label, places, keep_empty=False):
    return [
        (label, places[k], voxels[:, :, k] == label)
        for k in range(voxels.shape[2])
        if keep_empty or (voxels[:, :, k] == label).any()
    ]


def two_segments():
    voxels = np.zeros((7, 5, 6), int)  # 35 pixels a frame: bits go on in the middle of a byte
    voxels[1:6, 1:4, 0:2] = 1
    voxels[1:6, 1:4, 4:6] = 1  # nothing of segment 1 between
    voxels[2:4, 2:3, 1:3] = 5
    return voxels, [(10, 20, 30 + 3 * k) for k in range(6)]


def test_segmentation():
    voxels, places = two_segments()
    frames = segment_frames(voxels, 1, places) + segment_frames(voxels, 5, places)
    for syntax in (ExplicitVRLittleEndian, ImplicitVRLittleEndian, DeflatedExplicitVRLittleEndian):
        check(voxels, AFFINE, save(segmentation(frames, (1, 5)), "seg.dcm", syntax))
    for thickness, reported in ((1, ["apart: 3 is taken", "thickness of 1"]), (3, []), (5, [])):
        thick = segmentation(frames, (1, 5), measures=(0.5, 0.25, 0))
        thick.SharedFunctionalGroupsSequence[0].PixelMeasuresSequence[0].SliceThickness = thickness
        check(voxels, AFFINE, save(thick, "thick.dcm"), reported=reported)
    spread = np.zeros((7, 5, 16), int)
    spread[:, :, ::3] = voxels
    thin = AFFINE.copy()
    thin[2, 2] = 1
    check(
        spread, thin, save(segmentation(frames, (1, 5), measures=(0.5, 0.25, 1)), "spread.dcm"), reported=["no frame"]
    )
    mixed = [frames[i] for i in np.random.default_rng(1).permutation(len(frames))]
    check(voxels, AFFINE, save(segmentation(mixed, (1, 5)), "mixed.dcm"))
    check(voxels, AFFINE, save(segmentation(mixed, (1, 5), measures=(0.5, 0.25, 0)), "unspaced.dcm"))
    full = segment_frames(voxels, 1, places, True) + segment_frames(voxels, 5, places, True)
    check(voxels, AFFINE, save(segmentation(full, (1, 5)), "full.dcm"))
    for characters in ("ISO_IR 100", "ISO_IR 192"):
        named = segmentation(frames, (1, 5), ("S\u00e4ugerleber", "Tumor"))
        named.SpecificCharacterSet = characters
        output = run_dump([save(named, "names.dcm")])[0].stdout
        assert "name: 1 S\u00e4ugerleber\n" in output and "name: 5 Tumor\n" in output, output
    os.makedirs(path("one"), exist_ok=True)
    check(voxels, AFFINE, os.path.dirname(save(segmentation(full, (1, 5)), "one/seg.dcm")))


def test_turned_segmentation():
    voxels, _ = two_segments()
    places = [(10 - 3 * k, 20, 30) for k in range(6)]  # the normal of TURNED is -x
    frames = segment_frames(voxels, 1, places) + segment_frames(voxels, 5, places)
    affine = np.array([[0, 0, -3, 10], [0.25, 0, 0, 20], [0, -0.5, 0, 30.0]])
    check(voxels, affine, save(segmentation(frames, (1, 5), orientation=TURNED), "turned.dcm"))


def test_overlapping_segments():
    voxels, places = two_segments()
    liver = [(1, places[k], np.isin(voxels[:, :, k], (1, 5))) for k in range(6)]
    for frames in (liver + segment_frames(voxels, 5, places), segment_frames(voxels, 5, places) + liver):
        check(
            voxels,
            AFFINE,
            save(segmentation(frames, (1, 5)), "overlap.dcm"),
            reported=["4 voxels are in segment 1 and in segment 5", "the later one"],
        )


def test_fractional_segments():
    voxels, places = two_segments()
    frames = [(n, p, np.where(pixels, 200, 60)) for n, p, pixels in segment_frames(voxels, 1, places, True)]
    dataset = segmentation(frames, (1, 5), kind="FRACTIONAL", bits=8)
    dataset.MaximumFractionalValue = 255
    check((voxels == 1).astype(int), AFFINE, save(dataset, "fractions.dcm"), reported=["from a half on"])


def test_label_map_segmentation():
    voxels, places = two_segments()
    dataset = frames_dataset(LABEL_MAP, np.array([voxels[:, :, k].T for k in range(6)]), places, bits=8)
    dataset.SegmentationType = "LABELMAP"
    check(voxels, AFFINE, save(dataset, "labelmap.dcm"))
    dataset = frames_dataset(LABEL_MAP, np.array([voxels[:, :, k % 6].T for k in range(12)]), 2 * places, bits=8)
    dataset.SegmentationType = "LABELMAP"
    refused(FORMAT, "the 1st frame and the 7th frame lie at the same place", save(dataset, "times.dcm"))


def test_strange_segmentations():
    voxels, places = two_segments()
    frames = segment_frames(voxels, 1, places)
    refused(FORMAT, "segment 1", save(segmentation(frames, (2, 5)), "unlisted.dcm"))
    uneven = [(n, (10, 20, z), pixels) for (n, _, pixels), z in zip(frames, (30, 31.7, 35, 42))]
    refused(FORMAT, "evenly spaced", save(segmentation(uneven, (1, 5)), "uneven.dcm"))
    again = "the 2nd frame and the 5th frame lie at the same place and hold the same segment"
    refused(FORMAT, again, save(segmentation(frames + frames[1:2], (1, 5)), "again.dcm"))
    refused(FORMAT, "KIND", save(segmentation(frames, (1, 5), kind="KIND"), "kind.dcm"))
    dataset = segmentation(frames, (1, 5))
    del dataset.PerFrameFunctionalGroupsSequence[1].PlanePositionSequence
    refused(FORMAT, "the 2nd frame does not tell where", save(dataset, "placeless.dcm"))
    dataset = segmentation(frames, (1, 5))
    dataset.PixelData = dataset.PixelData[:8]
    refused(FORMAT, "damaged", save(dataset, "short.dcm"))


def test_what_holds_no_volume():
    structures = new(RT_STRUCTURES, Modality="RTSTRUCT")
    refused(UNSUPPORTED, ["RT structure set", "contours"], save(structures, "contours.dcm"))
    refused(
        FORMAT, ["no image", "1.2.840.10008.5.1.4.1.1.88.11"], save(new("1.2.840.10008.5.1.4.1.1.88.11"), "report.dcm")
    )
    colours = slice_of(random_labels((6, 4), (0, 3)), (0, 0, 0))
    colours.SamplesPerPixel = 3
    refused(FORMAT, "colours", save(colours, "colours.dcm"))


def test_damaged():
    """Cut and changed files are read or refused; never a crash, and nothing is printed."""
    voxels, places = two_segments()
    frames = segment_frames(voxels, 1, places) + segment_frames(voxels, 5, places)
    dataset = slice_of(voxels[:, :, 0], (0, 0, 0))
    dataset.PixelData = encapsulate([packed_by_runs(voxels[:, :, 0].T)])
    dataset["PixelData"].is_undefined_length = True
    sources = [
        save(segmentation(frames, (1, 5)), "whole.dcm"),
        save(dataset, "whole_runs.dcm", RLELossless),
        save(segmentation(frames, (1, 5)), "whole_implicit.dcm", ImplicitVRLittleEndian),
    ]
    random = np.random.default_rng(3)
    for source in sources:
        data = open(source, "rb").read()
        for trial in range(40):
            damaged = bytearray(data[: random.integers(len(data))] if trial % 4 == 0 else data)
            for _ in range(trial % 4 * 3):
                damaged[random.integers(128, len(damaged)) if len(damaged) > 129 else 0] = random.integers(256)
            open(path("damaged.dcm"), "wb").write(damaged)
            run_dump([path("damaged.dcm")])
    head = bytes(128) + b"DICM"
    long = head + b"\2\0\0\0UL\4\0\xff\xff\xff\xff\2\0\x10\0UI\xff\xff" + b"1.2.8401" * 16
    for name, data in (("trunc", head), ("long", long), ("bare", head[:131])):
        open(path(name + ".dcm"), "wb").write(data)
        run, _ = run_dump([path(name + ".dcm")])
        assert run.returncode == 1, name
    run, _ = run_dump(["/etc"])
    assert run.returncode == 1


run_tests(globals())
