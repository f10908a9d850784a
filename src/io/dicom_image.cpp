// Single DICOM files: a slice, a volume of frames, a segmentation; and by name what is none of these.
#include "io/dicom_image.hpp"

#include "base/error.hpp"
#include "base/ordinal.hpp"
#include "io/dicom_pixels.hpp"
#include "io/dicom_planes.hpp"
#include "io/dicom_segmentation.hpp"
#include "io/dicom_series.hpp"

#include <algorithm>
#include <string_view>

namespace cleft::io
{

namespace
{

// Where its frames lie, if the file tells; in the order of the frames.
// The order of frames in a file says nothing of their places: enhanced CT and MR often store time
// or contrast first.
void sort_frames(const std::vector<DicomPlane>& planes, Image& image)
{
    std::vector<std::string> who;
    for (size_t f = 0; f < planes.size(); ++f) {
        who.push_back("the " + ordinal(static_cast<int64_t>(f)) + " frame");
        // Frames of ultrasound and angiography are pictures over time and have no Image Position
        // (Patient).
        if (!planes[f].placed)
            throw Error(CLEFT_ERROR_FORMAT, "it has " + std::to_string(planes.size()) +
                                                " frames and does not tell where they lie: a series over time, or "
                                                "views, is no volume");
    }
    put_in_slots(stack_of(planes, who), image);
}

// Was it ever compressed so that values change? The two are JPEG, which cannot do otherwise.
// The attribute Lossy Image Compression (0028,2110) of PS3.3, section C.7.6.1 also tells of a
// compression that was undone since.
bool is_lossy(const DicomFile& file)
{
    // JPEG baseline (process 1) and extended (processes 2 and 4).
    static constexpr std::string_view kAlways[] = {"1.2.840.10008.1.2.4.50", "1.2.840.10008.1.2.4.51"};
    const auto lossy = std::find(std::begin(kAlways), std::end(kAlways), file.transfer_syntax);
    return lossy != std::end(kAlways) || file.data.text(0x00282110u) == "01";
}

// What is read, but may surprise.
void note_doubts(const DicomFile& file, const DicomPlane& plane, std::vector<std::string>& notes)
{
    // Secondary captures and screenshots have no Pixel Spacing. The mesh then has the right shape
    // in an unknown unit.
    if (!plane.sized)
        notes.emplace_back("it does not tell the size of a pixel: 1 x 1 is taken");
    // Imager Pixel Spacing (0018,1164) of projection images is measured at the detector. The object
    // lies nearer to the source, so it is smaller.
    else if (plane.at_detector)
        notes.emplace_back("it tells the size of a pixel at the detector alone, which is taken");
    // Photometric Interpretation tells how to show the numbers. Inverting them, as viewers do,
    // would change all labels.
    if (file.data.text(0x00280004u) == "MONOCHROME1")
        notes.emplace_back("it says that 0 is white (MONOCHROME1): the labels are the numbers in the file");
    if (is_lossy(file))
        notes.emplace_back("its pixels were compressed in a way that changes values, and so labels");
    // Modality LUT Sequence. Its output is a measured quantity, and a label map has none.
    if (file.data.has(0x00283000u))
        notes.emplace_back("its table of values (Modality LUT) is not applied to the voxels");
}

}  // namespace

// Archives hand out these objects beside the images of a study, so users meet them first. Each is
// named with what to do about it.
void check_dicom_is_image(const DicomFile& file)
{
    // By SOP Class UID (PS3.4, section B.5).
    struct Row {
        const char* storage;
        const char* what;
    };
    static constexpr Row kOthers[] = {
        {"1.2.840.10008.5.1.4.1.1.481.3",
         "an RT structure set: contours, not voxels; make a label map of it, for "
         "instance in 3D Slicer"},
        {"1.2.840.10008.5.1.4.1.1.481.2", "an RT dose: amounts of radiation, not labels"},
        {"1.2.840.10008.5.1.4.1.1.481.5", "an RT plan: numbers for a treatment, not voxels"},
        {"1.2.840.10008.5.1.4.1.1.66.5", "a surface segmentation: triangles, not voxels"},
        {"1.2.840.10008.5.1.4.1.1.104.1", "a document"},
    };
    const std::string storage = file.data.text(0x00080016u);
    // Directory Record Sequence: only a DICOMDIR has it.
    if (file.data.has(0x00041220u))
        throw Error(CLEFT_ERROR_UNSUPPORTED, "it is a DICOMDIR, a list of other files: give the folder of a series");
    for (const Row& row : kOthers)
        if (storage == row.storage)
            throw Error(CLEFT_ERROR_UNSUPPORTED, std::string("it is ") + row.what);
    // Pixel Data, Float Pixel Data and Double Float Pixel Data.
    if (!file.data.has(0x7FE00010u) && !file.data.has(0x7FE00008u) && !file.data.has(0x7FE00009u))
        throw Error(CLEFT_ERROR_FORMAT,
                    "the DICOM file holds no image" +
                        (storage.empty() ? std::string() : " (its class is " + ascii_of(storage) + ")"));
}

Image read_dicom_frames(const DicomFile& file, std::vector<DicomPlane>& planes)
{
    check_dicom_is_image(file);
    const DicomPixelFormat format = pixel_format_of(file);
    planes = planes_of(file, format.frames);
    Image image = pixels_of(file, format);
    note_doubts(file, planes.front(), image.notes);
    return image;
}

bool is_dicom(const FileHead& head) { return is_dicom_head(head.text()); }

Image read_dicom_image(const std::string& path, const FileHead&)
{
    const DicomFile file = read_dicom_file(path);
    if (is_dicom_segmentation(file))
        return read_dicom_segmentation(file);
    std::vector<DicomPlane> planes;
    Image image = read_dicom_frames(file, planes);
    rescale(planes, image);
    // A single frame needs no place: then its plane gives directions and spacing as far as they are
    // known.
    if (planes.size() > 1) {
        sort_frames(planes, image);
    } else {
        set_plane(planes.front(), image);
        image.placed = planes.front().placed;
    }
    return image;
}

}  // namespace cleft::io
