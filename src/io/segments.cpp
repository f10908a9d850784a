// Keys such as Segment3_Name of .seg.nrrd files. A segment is a layer and the value that its voxels have in it.
#include "io/segments.hpp"

#include "base/counted.hpp"
#include "base/error.hpp"
#include "io/ascii.hpp"
#include "io/header_values.hpp"
#include "io/voxel_access.hpp"

#include <algorithm>
#include <cstring>
#include <set>

namespace cleft::io
{

namespace
{

using Keys = std::map<std::string, std::string>;

struct Segment {
    std::string name;
    int64_t layer = 0;
    int64_t value = 0;
    int32_t label = 0;
};

std::string value_of(const Keys& keys, const std::string& key, const std::string& otherwise)
{
    const auto found = keys.find(key);
    return found == keys.end() ? otherwise : found->second;
}

bool has_segment(const Keys& keys, size_t number)
{
    const std::string prefix = "Segment" + std::to_string(number) + "_";
    // The map is sorted, so that all keys of a segment follow its prefix.
    const auto found = keys.lower_bound(prefix);
    return found != keys.end() && found->first.compare(0, prefix.size(), prefix) == 0;
}

// Older files have neither layers nor values: each segment is a layer of its own, of ones.
Segment segment_of(const Keys& keys, size_t number)
{
    const std::string prefix = "Segment" + std::to_string(number) + "_";
    Segment segment;
    // Slicer always writes a name. Other writers may leave it out, and the ID is then all there is.
    segment.name = value_of(keys, prefix + "Name", value_of(keys, prefix + "ID", "segment " + std::to_string(number)));
    const bool old = keys.count(prefix + "LabelValue") == 0;
    segment.value = integer_of(prefix + "LabelValue", trimmed(value_of(keys, prefix + "LabelValue", "1")));
    segment.layer =
        integer_of(prefix + "Layer", trimmed(value_of(keys, prefix + "Layer", old ? std::to_string(number) : "0")));
    // 0 is "no segment" in every layer.
    if (segment.value == 0 || segment.value != static_cast<int32_t>(segment.value))
        refuse_field(prefix + "LabelValue", std::to_string(segment.value), "a number of 32 bits, not 0, is wanted");
    segment.label = static_cast<int32_t>(segment.value);
    return segment;
}

std::vector<Segment> segments_of(const Keys& keys, const Image& image)
{
    // Slicer renamed the key in version 5.
    for (const char* key : {"Segmentation_SourceRepresentation", "Segmentation_MasterRepresentation"})
        if (in_small_letters(value_of(keys, key, "")).find("fractional") != std::string::npos)
            throw Error(CLEFT_ERROR_UNSUPPORTED,
                        "it is a segmentation of fractions; store it as a binary labelmap in 3D Slicer");
    std::vector<Segment> segments;
    // Slicer numbers segments from 0 without gaps.
    while (has_segment(keys, segments.size())) {
        segments.push_back(segment_of(keys, segments.size()));
        const Segment& last = segments.back();
        // A layer is an index into the fields of the image and comes from text.
        if (last.layer < 0 || last.layer >= image.fields)
            throw Error(CLEFT_ERROR_FORMAT, "its segment '" + last.name + "' is in layer " +
                                                std::to_string(last.layer) + ", but there are " +
                                                std::to_string(image.fields) + " layers");
        for (const Segment& other : segments)
            // Such a voxel would belong to two segments with two names and one number.
            if (&other != &last && other.layer == last.layer && other.value == last.value)
                throw Error(CLEFT_ERROR_FORMAT,
                            "its segments '" + other.name + "' and '" + last.name + "' have the same layer and value");
    }
    if (is_floating(image.component))
        throw Error(CLEFT_ERROR_FORMAT, "it is a segmentation, but its voxels are no whole numbers");
    return segments;
}

// Segments of different layers with the same value get labels in the order of the file, from 1.
void number_apart(std::vector<Segment>& segments, Image& image)
{
    std::set<int32_t> labels;
    for (const Segment& segment : segments)
        labels.insert(segment.label);
    // The values of Slicer are kept as labels where they can be, since users know them.
    if (labels.size() == segments.size())
        return;
    std::string list;
    for (size_t s = 0; s < segments.size(); ++s) {
        segments[s].label = static_cast<int32_t>(s) + 1;
        list += (s == 0 ? "" : ", ") + std::to_string(s + 1) + " " + segments[s].name;
    }
    image.notes.push_back("segments of different layers have the same value, so that they are numbered anew: " + list);
}

template <class T>
// Signed and unsigned numbers of 32 bits both fit int64, so that values compare rightly.
std::vector<int64_t> widened(const Image& image)
{
    std::vector<int64_t> values(image.bytes() / sizeof(T));
    for (size_t i = 0; i < values.size(); ++i) {
        T value;
        std::memcpy(&value, &image.voxels[i * sizeof value], sizeof value);
        values[i] = static_cast<int64_t>(value);
    }
    return values;
}

std::vector<int64_t> whole_voxels(const Image& image)
{
    switch (image.component) {
        case Component::uint8:
            return widened<uint8_t>(image);
        case Component::int8:
            return widened<int8_t>(image);
        case Component::uint16:
            return widened<uint16_t>(image);
        case Component::int16:
            return widened<int16_t>(image);
        case Component::uint32:
            return widened<uint32_t>(image);
        case Component::int32:
            return widened<int32_t>(image);
        default:
            throw Error(CLEFT_ERROR_FORMAT, "a segmentation has whole numbers of up to 32 bits");
    }
}

// The number of the segment that has this value in this layer.
int32_t segment_with(const std::vector<Segment>& segments, int64_t layer, int64_t value)
{
    for (size_t s = 0; s < segments.size(); ++s)
        if (segments[s].layer == layer && segments[s].value == value)
            return static_cast<int32_t>(s);
    // A value that no segment has would become a label without a name in a map that is numbered by
    // segments.
    throw Error(CLEFT_ERROR_FORMAT, "its layer " + std::to_string(layer) + " has voxels of value " +
                                        std::to_string(value) + ", which is no segment");
}

// One label map of all layers.
void flatten(std::vector<Segment>& segments, Image& image)
{
    const std::vector<int64_t> values = whole_voxels(image);
    const auto count = static_cast<size_t>(image.field_size());
    std::vector<int32_t> winner(count, -1);  // the number of the segment
    std::vector<char> disputed(count, 0);
    for (int64_t layer = 0; layer < image.fields; ++layer) {
        // Few values occur in a layer; each is looked up in the list once.
        std::map<int64_t, int32_t> number_of;
        for (size_t voxel = 0; voxel < count; ++voxel) {
            const int64_t value = values[static_cast<size_t>(layer) * count + voxel];
            if (value == 0)
                continue;
            auto found = number_of.find(value);
            if (found == number_of.end())
                found = number_of.emplace(value, segment_with(segments, layer, value)).first;
            if (winner[voxel] >= 0)
                disputed[voxel] = 1;
            // The documentation promises it: the segment further down the list is on top.
            winner[voxel] = std::max(winner[voxel], found->second);
        }
    }
    // After the voxels have found their segments by value, since it changes labels only.
    number_apart(segments, image);
    image.fields = 1;
    image.component = Component::int32;
    allocate_voxels(image);
    for (size_t voxel = 0; voxel < count; ++voxel) {
        const int32_t label = winner[voxel] < 0 ? 0 : segments[static_cast<size_t>(winner[voxel])].label;
        std::memcpy(&image.voxels[voxel * sizeof label], &label, sizeof label);
    }
    const auto shared = std::count(disputed.begin(), disputed.end(), 1);
    if (shared > 0)
        image.notes.push_back(counted(shared, "voxel belongs", "voxels belong") +
                              " to segments of several layers; the last such segment in the file holds");
}

// In one layer, voxels keep their values, also those that are no segment.
void note_values_without_segment(const std::vector<Segment>& segments, Image& image)
{
    std::set<int64_t> known{0};
    std::set<int64_t> strange;
    for (const Segment& segment : segments)
        known.insert(segment.value);
    // Runs of one value need one look-up. 0 is known, so it may stand for the value before the
    // first.
    int64_t last = 0;
    for_each_value(image, 0, [&](int64_t, double number) {
        const auto value = static_cast<int64_t>(number);
        if (value != last && known.count(value) == 0)
            strange.insert(value);
        last = value;
    });
    if (!strange.empty())
        image.notes.push_back("it has voxels of value " + std::to_string(*strange.begin()) +
                              (strange.size() > 1 ? " and others" : "") +
                              ", which is no segment: their values are kept");
}

}  // namespace

bool has_segments(const Keys& keys)
{
    return keys.count("Segment0_ID") > 0 || keys.count("Segment0_Name") > 0 || keys.count("Segment0_LabelValue") > 0;
}

void check_segments(const Keys& keys, const Image& image) { segments_of(keys, image); }

void apply_segments(const Keys& keys, Image& image)
{
    std::vector<Segment> segments = segments_of(keys, image);
    if (image.fields > 1)
        flatten(segments, image);
    else
        note_values_without_segment(segments, image);
    for (const Segment& segment : segments)
        image.names.emplace_back(segment.label, segment.name);
}

}  // namespace cleft::io
