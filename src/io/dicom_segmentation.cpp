// Puts the frames of a segmentation object to their places, as labels.
#include "io/dicom_segmentation.hpp"

#include "base/counted.hpp"
#include "base/error.hpp"
#include "base/ordinal.hpp"
#include "io/dicom_pixels.hpp"
#include "io/dicom_planes.hpp"
#include "io/meaning.hpp"
#include "io/voxel_access.hpp"

#include <algorithm>
#include <map>

namespace cleft::io
{

namespace
{

// SOP Class UID, Segment Sequence, and Segment Identification Sequence (PS3.3, sections C.8.20.2 and C.8.20.3).
constexpr DicomTag kClassTag = 0x00080016u;
constexpr DicomTag kSegmentsTag = 0x00620002u;
constexpr DicomTag kIdentificationGroup = 0x0062000Au;

// Specific Character Set (0008,0005). ISO_IR 192 is UTF-8 and ISO_IR 6 is ASCII, which is UTF-8,
// too. ISO_IR 100 is Latin-1, whose codes are those of Unicode. Names in others are left out later,
// if they are no UTF-8.
std::string utf8_of(const std::string& text, const std::string& characters)
{
    if (characters != "ISO_IR 100")
        return text;
    std::string out;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 128) {
            out += c;
        } else {
            out += static_cast<char>(0xC0 | code >> 6);
            out += static_cast<char>(0x80 | (code & 0x3F));
        }
    }
    return out;
}

std::map<int32_t, std::string> segments_of(const DicomFile& file)
{
    std::map<int32_t, std::string> segments;
    for (const DicomData& segment : file.data.items(kSegmentsTag)) {
        // Segment Number and Segment Label.
        const auto number = static_cast<int32_t>(segment.short_number(0x00620004u, -1));
        segments[number] = utf8_of(segment.text(0x00620005u), file.data.text(0x00080005u));
    }
    return segments;
}

// Referenced Segment Number of the first Segment Identification, or `otherwise` where no group has
// one.
int32_t segment_in(const std::vector<DicomData>& groups, int32_t otherwise)
{
    for (const DicomData& group : groups)
        for (const DicomData& item : group.items(kIdentificationGroup))
            return static_cast<int32_t>(item.short_number(0x0062000Bu, otherwise));
    return otherwise;
}

// The segment of each frame. What all frames share may tell it, too.
std::vector<int32_t> segments_of_frames(const DicomFile& file, int64_t frames,
                                        const std::map<int32_t, std::string>& segments)
{
    const int32_t shared = segment_in(file.data.items(kSharedGroups), 0);
    std::vector<int32_t> all;
    for (const DicomData& frame : file.data.items(kFrameGroups))
        all.push_back(segment_in({frame}, shared));
    if (static_cast<int64_t>(all.size()) != frames)
        refuse_dicom("the segmentation has " + counted(frames, "frame") + ", but describes " +
                     std::to_string(all.size()));
    for (const int32_t number : all)
        // A frame of an unlisted segment has no name and no meaning. A label for it would be a
        // guess.
        if (segments.count(number) == 0)
            refuse_dicom("the segmentation has a frame of a segment " + std::to_string(number) +
                         ", which is not in its list");
    return all;
}

// Segments of one object may overlap (Segments Overlap, 0062,0013); a label map cannot hold that.
struct Overlaps {
    std::map<std::pair<int32_t, int32_t>, int64_t> voxels;  // of two segments; the second takes them
};

void note_overlaps(const Overlaps& overlaps, Image& image)
{
    for (const auto& [pair, voxels] : overlaps.voxels)
        image.notes.push_back(voxels_text(voxels) + (voxels == 1 ? " is" : " are") + " in segment " +
                              std::to_string(pair.first) + " and in segment " + std::to_string(pair.second) +
                              ": the later one takes " + (voxels == 1 ? "it" : "them"));
}

// Segments in the order of their numbers, so that the order of the frames does not matter.
Overlaps place_frames(const Image& frames, const std::vector<int32_t>& segment_of, const DicomStack& stack,
                      double threshold, Image& labels)
{
    const int64_t slice = labels.dims[0] * labels.dims[1];
    std::vector<size_t> order(segment_of.size());
    for (size_t f = 0; f < order.size(); ++f)
        order[f] = f;
    // By number and not by frame: the label of a voxel must not depend on the order in which a
    // program wrote its frames.
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return segment_of[a] < segment_of[b]; });
    Overlaps overlaps;
    for (const size_t f : order)
        for (int64_t p = 0; p < slice; ++p) {
            const auto stored =
                static_cast<double>(load<uint8_t>(frames.voxels.get(), static_cast<int64_t>(f) * slice + p));
            // Binary frames hold 0 and 1. Fractional ones hold 0 to Maximum Fractional Value.
            if (stored < threshold)
                continue;
            const int64_t voxel = stack.slots[f] * slice + p;
            const auto before = static_cast<int32_t>(load<uint16_t>(labels.voxels.get(), voxel));
            if (before != 0 && before != segment_of[f])
                ++overlaps.voxels[{before, segment_of[f]}];
            store<uint16_t>(labels.voxels.get(), voxel, static_cast<uint16_t>(segment_of[f]));
        }
    return overlaps;
}

// Frames of one segment at one place are of several times or resolutions, and the file does not tell which of them is
// meant. `segment_of` is empty where each frame holds all segments.
void check_frames_apart(const std::vector<int32_t>& segment_of, const DicomStack& stack)
{
    std::map<std::pair<int32_t, int64_t>, size_t> taken;
    for (size_t f = 0; f < stack.slots.size(); ++f) {
        const int32_t segment = segment_of.empty() ? 0 : segment_of[f];
        const auto [place, is_free] = taken.emplace(std::pair(segment, stack.slots[f]), f);
        if (!is_free)
            refuse_dicom("the " + ordinal(static_cast<int64_t>(place->second)) + " frame and the " +
                         ordinal(static_cast<int64_t>(f)) + " frame lie at the same place" +
                         (segment_of.empty() ? "" : " and hold the same segment") +
                         ": a series over time, or of several contrasts, is no volume");
    }
}

std::vector<std::string> frame_names(int64_t frames)
{
    std::vector<std::string> names;
    for (int64_t f = 0; f < frames; ++f)
        names.push_back("the " + ordinal(f) + " frame");
    return names;
}

void name_segments(const std::map<int32_t, std::string>& segments, Image& image)
{
    for (const auto& [number, name] : segments)
        if (!name.empty())
            image.names.emplace_back(number, name);
}

// Zeros at the place of the stack.
Image empty_labels(const DicomStack& stack, const DicomPixelFormat& format, Component component)
{
    Image labels;
    labels.dims = {format.columns, format.rows, stack.geometry.dims[2]};
    labels.component = component;
    set_place(stack, labels);
    labels.notes = stack.geometry.notes;
    allocate_voxels(labels);
    std::fill_n(labels.voxels.get(), labels.bytes(), std::byte{0});
    return labels;
}

// In a LABELMAP the pixels are the numbers of the segments, so frames are copied whole.
Image labels_of_numbers(const Image& frames, const DicomPixelFormat& format, const DicomStack& stack)
{
    check_frames_apart({}, stack);
    Image labels = empty_labels(stack, format, frames.component);
    copy_to_slots(stack, frames, labels);
    return labels;
}

// In the other types a frame is the mask of one segment.
Image labels_of_masks(const DicomFile& file, const Image& frames, const DicomPixelFormat& format,
                      const DicomStack& stack, bool fractional)
{
    if (frames.component != Component::uint8)
        refuse_dicom("its segmentation has pixels of " + std::to_string(format.bits_allocated) +
                     " bits, which cannot be read");
    const std::vector<int32_t> segment_of = segments_of_frames(file, format.frames, segments_of(file));
    check_frames_apart(segment_of, stack);
    // Segment Number is an unsigned number of 16 bits.
    Image labels = empty_labels(stack, format, Component::uint16);
    // Maximum Fractional Value. 255 is what its writers mostly use; the attribute is required for
    // fractions.
    const double greatest = static_cast<double>(file.data.short_number(0x0062000Eu, 255));
    note_overlaps(place_frames(frames, segment_of, stack, fractional ? greatest / 2 : 1, labels), labels);
    if (fractional)
        labels.notes.push_back("its segments are fractions: a voxel belongs to a segment from a half on");
    return labels;
}

}  // namespace

bool is_dicom_segmentation(const DicomFile& file)
{
    const std::string storage = file.data.text(kClassTag);
    // Segmentation Storage and Label Map Segmentation Storage.
    return storage == "1.2.840.10008.5.1.4.1.1.66.4" || storage == "1.2.840.10008.5.1.4.1.1.66.7";
}

Image read_dicom_segmentation(const DicomFile& file)
{
    // Segmentation Type.
    const std::string type = file.data.text(0x00620001u);
    const bool fractional = type == "FRACTIONAL";
    if (type != "BINARY" && !fractional && type != "LABELMAP")
        refuse_dicom("it is a DICOM segmentation of the type '" + ascii_of(type) + "', which cannot be read");
    const DicomPixelFormat format = pixel_format_of(file);
    const Image frames = pixels_of(file, format);
    // A segment has frames only where it has voxels, so places repeat and leave gaps.
    const DicomStack stack = loose_stack_of(planes_of(file, format.frames), frame_names(format.frames));
    Image labels = type == "LABELMAP" ? labels_of_numbers(frames, format, stack)
                                      : labels_of_masks(file, frames, format, stack, fractional);
    name_segments(segments_of(file), labels);
    return labels;
}

}  // namespace cleft::io
