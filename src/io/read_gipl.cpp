// GIPL: 256 bytes of header, always big-endian, then the voxels; the whole may be gzip.
#include "io/binary_header.hpp"
#include "io/header_values.hpp"
#include "io/image_readers.hpp"
#include "io/voxel_data.hpp"

#include <map>

namespace cleft::io
{

namespace
{

constexpr size_t kGiplHeaderBytes = 256;
// The two magic numbers in use, in the last four bytes of the header.
constexpr uint32_t kMarks[] = {719555000, 4026526128};

Component component_of(uint16_t type)
{
    // Type 1 is binary: programs store it with a byte for each voxel. Complex types and colours are
    // left out.
    static const std::map<uint16_t, Component> types{
        {1, Component::uint8},  {7, Component::int8},     {8, Component::uint8},
        {15, Component::int16}, {16, Component::uint16},  {31, Component::uint32},
        {32, Component::int32}, {64, Component::float32}, {65, Component::float64}};
    const auto found = types.find(type);
    if (found == types.end())
        refuse_field("image type", std::to_string(type), "such voxels cannot be read");
    return found->second;
}

}  // namespace

bool is_gipl(const FileHead& head)
{
    if (head.content.size() < kGiplHeaderBytes)
        return false;
    const auto mark = BinaryHeader(head.content, true).at<uint32_t>(252);
    return mark == kMarks[0] || mark == kMarks[1];
}

Image read_gipl(const std::string& path, const FileHead& head)
{
    const BinaryHeader header(head.content, true);
    Image image;
    image.component = component_of(header.at<uint16_t>(8));
    for (size_t axis = 0; axis < 4; ++axis) {
        const auto size = std::max<int64_t>(1, header.at<uint16_t>(2 * axis));  // 0: there is no such axis
        (axis < 3 ? image.dims[axis] : image.fields) = size;
    }
    for (size_t axis = 0; axis < 3; ++axis) {
        image.spacing[axis] = static_cast<double>(header.at<float>(10 + 4 * axis));
        image.origin[axis] = header.at<double>(204 + 8 * axis);
        // The origin says where the first voxel is, but a negative size leaves open whether x grows
        // from there.
        if (image.spacing[axis] < 0)
            refuse_field("pixel size", std::to_string(image.spacing[axis]), "it must be positive");
    }
    // A single slice is as thick as it is wide.
    if (image.dims[2] == 1 && image.spacing[2] == 0)
        image.spacing[2] = image.spacing[0];
    VoxelData data;
    data.big_endian = true;
    data.attached = true;
    data.files = {path};
    data.encoding = head.gzip ? VoxelData::Encoding::deflated : VoxelData::Encoding::raw;
    // skip counts decompressed bytes, so it is right where the whole file is gzip, too.
    data.skip = kGiplHeaderBytes;
    read_voxels(data, image);
    return image;
}

}  // namespace cleft::io
