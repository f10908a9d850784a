// MetaImage (.mha, .mhd): what its fields say of the grid, and where its voxels are.
#include "base/counted.hpp"
#include "base/error.hpp"
#include "io/ascii.hpp"
#include "io/header_values.hpp"
#include "io/image_readers.hpp"
#include "io/metaimage_header.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace cleft::io
{

namespace
{

Component component_of(const MetaFields& fields)
{
    // The numeric types of MetaIO's metaTypes.h. Arrays of them (MET_FLOAT_ARRAY) and text are not
    // voxels.
    static const std::map<std::string, Component> types{
        {"MET_CHAR", Component::int8},       {"MET_UCHAR", Component::uint8},       {"MET_SHORT", Component::int16},
        {"MET_USHORT", Component::uint16},   {"MET_INT", Component::int32},         {"MET_UINT", Component::uint32},
        {"MET_LONG", Component::int32},      {"MET_ULONG", Component::uint32},  // four bytes in any of its writers
        {"MET_LONG_LONG", Component::int64}, {"MET_ULONG_LONG", Component::uint64}, {"MET_FLOAT", Component::float32},
        {"MET_DOUBLE", Component::float64}};
    const auto type = fields.find("ElementType");
    if (type == fields.end())
        throw Error(CLEFT_ERROR_FORMAT, "its header has no field 'ElementType'");
    const auto found = types.find(type->second);
    if (found == types.end())
        refuse_field("ElementType", type->second, "such voxels cannot be read");
    return found->second;
}

std::vector<int64_t> sizes_of(const MetaFields& fields)
{
    const auto kind = fields.find("ObjectType");
    // MetaIO stores tubes, meshes and scenes under the same keys.
    if (kind != fields.end() && kind->second != "Image")
        refuse_field("ObjectType", kind->second, "only an Image is a volume");
    for (const char* key : {"NDims", "DimSize"})
        if (fields.count(key) == 0)
            throw Error(CLEFT_ERROR_FORMAT, std::string("its header has no field '") + key + "'");
    const std::string& number = fields.at("NDims");
    const int64_t axes = integer_of("NDims", number);
    if (axes < 2 || axes > 4)
        refuse_field("NDims", number, "a volume has 2 to 4 dimensions");
    const std::vector<int64_t> sizes = integers_of("DimSize", fields.at("DimSize"), static_cast<size_t>(axes));
    for (const int64_t size : sizes)
        if (size < 1)
            refuse_field("DimSize", fields.at("DimSize"), "an axis must have a voxel");
    const auto channels = fields.find("ElementNumberOfChannels");
    if (channels != fields.end() && integer_of("ElementNumberOfChannels", channels->second) != 1)
        throw Error(CLEFT_ERROR_FORMAT,
                    "it has " + channels->second + " numbers a voxel (colours or vectors); one is wanted");
    return sizes;
}

// The rows of the matrix are the directions of the axes. A fourth axis must keep to itself.
void set_directions(const MetaFields& fields, size_t axes, Image& image)
{
    const auto* matrix = one_meta_field(fields, {"TransformMatrix", "Rotation", "Orientation"});
    if (!matrix)
        return;
    const std::vector<double> numbers = reals_of(matrix->first, matrix->second, axes * axes);
    const size_t space = std::min<size_t>(axes, 3);
    for (size_t axis = 0; axis < axes; ++axis)
        for (size_t row = 0; row < axes; ++row)
            // A fourth axis counts volumes. Turned into space, it would move the voxels from volume
            // to volume.
            if ((axis > 2) != (row > 2) && numbers[axis * axes + row] != 0)
                refuse_field(matrix->first, matrix->second, "the fourth axis is turned into the others");
    for (size_t axis = 0; axis < space; ++axis) {
        Vector3 direction{0, 0, 0};
        for (size_t row = 0; row < space; ++row)
            direction[row] = numbers[axis * axes + row];
        const double norm = length(direction);
        if (!(norm > 0) || !std::isfinite(norm))
            refuse_field(matrix->first, matrix->second, "an axis has no direction");
        image.directions[axis] = times(1 / norm, direction);
        // ITK scales directions to length 1, but files of other programs keep the spacing in the
        // matrix.
        image.spacing[axis] *= norm;
    }
}

void set_geometry(const MetaFields& fields, size_t axes, Image& image)
{
    const size_t space = std::min<size_t>(axes, 3);
    const auto spacing = fields.find("ElementSpacing");
    // ElementSize is the size of a voxel in the scanner, which may overlap. ElementSpacing is the
    // distance that counts.
    const auto size = spacing != fields.end() ? spacing : fields.find("ElementSize");
    if (size != fields.end()) {
        const std::vector<double> numbers = reals_of(size->first, size->second, axes);
        std::copy_n(numbers.begin(), space, image.spacing.begin());
    } else {
        image.notes.emplace_back("it gives no ElementSpacing, which is taken for 1");
    }
    if (const auto* origin = one_meta_field(fields, {"Offset", "Position", "Origin"})) {
        const std::vector<double> numbers = reals_of(origin->first, origin->second, axes);
        std::copy_n(numbers.begin(), space, image.origin.begin());
    }
    set_directions(fields, axes, image);
    for (size_t axis = 0; axis < space; ++axis)
        // A negative spacing is a flipped axis; the grid itself stays the same.
        if (image.spacing[axis] < 0) {
            image.spacing[axis] = -image.spacing[axis];
            image.directions[axis] = times(-1, image.directions[axis]);
        }
    if (axes == 2)
        image.spacing[2] = image.spacing[0];
}

// Each of several files holds all of the first so many axes.
void check_number_of_files(const std::vector<std::string>& files, int64_t held, const std::vector<int64_t>& sizes)
{
    int64_t wanted = 1;
    for (size_t axis = static_cast<size_t>(held); axis < sizes.size(); ++axis)
        if (__builtin_mul_overflow(wanted, sizes[axis], &wanted))
            throw Error(CLEFT_ERROR_TOO_LARGE, "there are too many voxels");
    if (static_cast<int64_t>(files.size()) != wanted)
        refuse_field("ElementDataFile", counted(static_cast<int64_t>(files.size()), "file"),
                     counted(wanted, "is", "are") + " wanted for the sizes that are given");
}

std::vector<std::string> files_of(const MetaHeader& header, const std::vector<int64_t>& sizes)
{
    const std::string& value = header.fields.at("ElementDataFile");
    const std::vector<std::string> words = words_of(value);
    const auto axes = static_cast<int64_t>(sizes.size());
    if (words.empty())
        refuse_field("ElementDataFile", value, "a name is wanted");
    if (is_meta_list(value)) {
        // The number says how many axes each file of the list has.
        std::string held = value.substr(4);  // "LIST", "LIST2D", "LIST 2D"
        held = std::string(trimmed(held));
        if (!held.empty() && (held.back() == 'D' || held.back() == 'd'))
            held.pop_back();
        const int64_t number = held.empty() ? axes - 1 : integer_of("ElementDataFile", held);
        if (number < 1 || number > axes)
            refuse_field("ElementDataFile", value, "a file holds between one and all dimensions");
        check_number_of_files(header.list, number, sizes);
        return header.list;
    }
    if (value.find('%') == std::string::npos)
        return {value};
    const auto number = [&](size_t word, int64_t otherwise) {
        return words.size() > word ? integer_of("ElementDataFile", words[word]) : otherwise;
    };
    if (words.size() > 4)
        refuse_field("ElementDataFile", value, "a pattern is followed by the first number, the last, and the step");
    // MetaIO's pattern: first number, last, and step, which all have defaults.
    const std::vector<std::string> files =
        names_of_pattern("ElementDataFile", words[0], number(1, 1), number(2, sizes.back()), number(3, 1));
    check_number_of_files(files, axes - 1, sizes);
    return files;
}

void set_encoding(const MetaFields& fields, Component component, VoxelData& data, Image& image)
{
    const bool compressed = meta_truth_of(fields, "CompressedData", false);
    // Both names are in use; the first is that of ITK's writer.
    const auto* order = one_meta_field(fields, {"BinaryDataByteOrderMSB", "ElementByteOrderMSB"});
    if (order)
        data.big_endian = meta_truth_of(fields, order->first, false);
    if (!meta_truth_of(fields, "BinaryData", true)) {
        if (compressed)
            refuse_field("CompressedData", "True", "numbers of text are not compressed");
        data.encoding = VoxelData::Encoding::text;
        return;
    }
    if (!order && size_of(component) > 1)
        image.notes.emplace_back("it does not give the order of bytes, which is taken for little-endian");
    if (!compressed)
        return;
    data.encoding = VoxelData::Encoding::deflated;
    const auto length = fields.find("CompressedDataSize");
    // With the length, bytes behind the compressed data are not taken for a second gzip member.
    if (length != fields.end() && data.files.size() == 1) {
        const int64_t bytes = integer_of("CompressedDataSize", length->second);
        if (bytes < 1)
            refuse_field("CompressedDataSize", length->second, "a number of bytes is wanted");
        data.length = static_cast<uintmax_t>(bytes);
    }
}

VoxelData data_of(const std::string& path, const MetaHeader& header, const std::vector<int64_t>& sizes, Image& image)
{
    VoxelData data;
    const std::string value = in_small_letters(header.fields.at("ElementDataFile"));
    // "LOCAL": the data follow the header, as in .mha.
    if (value == "local") {
        data.files = {path};
        data.attached = true;
        data.offset = static_cast<int64_t>(header.end);
    } else {
        for (const std::string& name : files_of(header, sizes))
            data.files.push_back(beside(path, name));
    }
    set_encoding(header.fields, image.component, data, image);
    // -1: the data are at the end of the file, whatever stands before them.
    const auto skip = header.fields.find("HeaderSize");
    if (skip != header.fields.end()) {
        const int64_t bytes = integer_of("HeaderSize", skip->second);
        if (bytes < -1 || (bytes == -1 && data.encoding != VoxelData::Encoding::raw))
            refuse_field("HeaderSize", skip->second, "it may be -1 for raw data, and not less");
        if (bytes != 0)
            data.offset = bytes;
    }
    return data;
}

void note_unscaled_values(const MetaFields& fields, Image& image)
{
    const auto differs = [&](const char* key, double neutral) {
        const auto found = fields.find(key);
        return found != fields.end() && real_of(key, found->second) != neutral;
    };
    // They turn numbers into a measured quantity. MetaIO's readers do not apply them to the voxels
    // either.
    if (differs("ElementToIntensityFunctionSlope", 1) || differs("ElementToIntensityFunctionOffset", 0) ||
        differs("ElementToIntensityFunctionIntercept", 0))
        image.notes.emplace_back("its field 'ElementToIntensityFunctionSlope' is not applied to the voxels");
}

}  // namespace

// The format has no mark of its own.
bool is_metaimage(const FileHead& head)
{
    if (head.gzip)
        return false;
    if (head.extension == ".mha" || head.extension == ".mhd")
        return true;
    const std::string_view text = trimmed(head.text().substr(0, 200));
    return text.substr(0, 10) == "ObjectType" && text.find("NDims") != std::string_view::npos;
}

StoredImage locate_metaimage(const std::string& path, const FileHead&)
{
    const MetaHeader header = read_meta_header(path);
    const std::vector<int64_t> sizes = sizes_of(header.fields);
    StoredImage stored;
    Image& image = stored.image;
    image.component = component_of(header.fields);
    std::copy_n(sizes.begin(), std::min<size_t>(sizes.size(), 3), image.dims.begin());
    if (sizes.size() == 4)
        image.fields = sizes[3];
    set_geometry(header.fields, sizes.size(), image);
    note_unscaled_values(header.fields, image);
    note_unknown_fields(header.fields, image.notes);
    stored.data = data_of(path, header, sizes, image);
    return stored;
}

Image read_metaimage(const std::string& path, const FileHead& head)
{
    StoredImage stored = locate_metaimage(path, head);
    read_voxels(stored.data, stored.image);
    return std::move(stored.image);
}

}  // namespace cleft::io
