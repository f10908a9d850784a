// MRC, of electron microscopy: 1024 bytes of header in either order of bytes, an extension, then the voxels.
#include "base/ordinal.hpp"
#include "io/binary_header.hpp"
#include "io/header_values.hpp"
#include "io/image_readers.hpp"
#include "io/voxel_data.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::io
{

namespace
{

// Offsets are those of the words of MRC2014 (Cheng et al., 2015), four bytes each and counted from 1: word 53 is MAP.
constexpr size_t kMrcHeaderBytes = 1024;
constexpr size_t kMarkPlace = 208;
// "IMOD" in word 39: the flags in word 40 are then those of IMOD.
constexpr int32_t kImodStamp = 1146047817;
constexpr int32_t kImodSignedBytes = 1;
constexpr int32_t kImodOriginOfStandard = 4;  // otherwise it has the other sign
constexpr int32_t kImodPairsOf4Bits = 16;

bool is_of_imod(const BinaryHeader& header) { return header.at<int32_t>(152) == kImodStamp; }

bool has_imod_flag(const BinaryHeader& header, int32_t flag)
{
    return is_of_imod(header) && (header.at<int32_t>(156) & flag) != 0;
}

bool is_of_2014(const BinaryHeader& header)
{
    // NVERSION: the year times 10 and the version within it. Before MRC2014 it is 0 or noise.
    const auto version = header.at<int32_t>(108);
    return version >= 20140 && version < 20200;
}

// Bytes are signed since 2014; before, and in files of IMOD that do not say so, they are not.
bool has_signed_bytes(const BinaryHeader& header)
{
    return is_of_imod(header) ? has_imod_flag(header, kImodSignedBytes) : is_of_2014(header);
}

Component component_of(const BinaryHeader& header)
{
    // MODE of MRC2014. Modes 3 and 4 are complex, 12 is half precision, and 101 has four bits.
    const auto mode = header.at<int32_t>(12);
    switch (mode) {
        case 0:
            if (has_imod_flag(header, kImodPairsOf4Bits))
                refuse_field("MODE", "0", "its bytes are pairs of numbers of 4 bits, which cannot be read");
            return has_signed_bytes(header) ? Component::int8 : Component::uint8;
        case 1:
            return Component::int16;
        case 2:
            return Component::float32;
        case 6:
            return Component::uint16;
        default:
            refuse_field("MODE", std::to_string(mode), "such voxels cannot be read");
    }
}

void check_axes(const BinaryHeader& header)
{
    for (size_t axis = 0; axis < 3; ++axis) {
        // MAPC, MAPR and MAPS, words 17 to 19. 0 is what some programs leave, and means the usual
        // order.
        const auto which = header.at<int32_t>(64 + 4 * axis);
        if (which != 0 && which != static_cast<int32_t>(axis) + 1)
            refuse_field("MAPC, MAPR, MAPS", std::to_string(which), "only axes in the order x, y, z can be read");
        // CELLB, words 14 to 16: the angles of the cell. Crystals may have others, which would
        // shear the grid.
        const auto angle = header.at<float>(52 + 4 * axis);
        if (angle != 0 && !(std::abs(angle - 90) < 1e-3F))
            refuse_field("CELLB", std::to_string(angle), "only right angles can be read");
    }
    // ISPG, word 23: 401 and above are stacks of volumes.
    const auto group = header.at<int32_t>(88);
    if (group > 400)
        refuse_field("ISPG", std::to_string(group), "a stack of volumes cannot be read");
}

void set_place(const BinaryHeader& header, Image& image)
{
    // IMOD has the place of the world's origin from the first voxel, unless its flag or NVERSION says otherwise.
    const bool is_inverted = is_of_imod(header) && !has_imod_flag(header, kImodOriginOfStandard) && !is_of_2014(header);
    bool is_at_zero = true;
    for (size_t axis = 0; axis < 3; ++axis) {
        // The size of a voxel is CELLA over MX, MY, MZ, in angstroms.
        const auto steps = header.at<int32_t>(28 + 4 * axis);
        const auto extent = static_cast<double>(header.at<float>(40 + 4 * axis));
        image.spacing[axis] = steps > 0 && extent != 0 ? extent / steps : 1;
        if (steps <= 0 || extent == 0)
            image.notes.push_back("it gives no size of voxels along the " + ordinal(static_cast<int64_t>(axis)) +
                                  " axis, which is taken for 1");
        if (image.spacing[axis] < 0)
            refuse_field("CELLA", std::to_string(extent), "it must be positive");
        // ORIGIN, words 50 to 52, in angstroms. NXSTART and its kin give the place in voxels, in
        // older files. Programs disagree about them, so they are reported and not used.
        image.origin[axis] = static_cast<double>(header.at<float>(196 + 4 * axis));
        is_at_zero = is_at_zero && image.origin[axis] == 0;
        if (is_inverted)
            image.origin[axis] = 0 - image.origin[axis];
        if (header.at<int32_t>(16 + 4 * axis) != 0 && image.origin[axis] == 0)
            image.notes.push_back("its first voxel has the number " +
                                  std::to_string(header.at<int32_t>(16 + 4 * axis)) + " along the " +
                                  ordinal(static_cast<int64_t>(axis)) + " axis, which is not used");
    }
    if (is_inverted && !is_at_zero)
        image.notes.push_back("its origin is taken with the other sign, as IMOD has it in files without a flag for it");
}

}  // namespace

bool is_mrc(const FileHead& head)
{
    return !head.gzip && head.content.size() >= kMrcHeaderBytes && head.text().substr(kMarkPlace, 3) == "MAP";
}

Image read_mrc(const std::string& path, const FileHead& head)
{
    // MACHST, word 54: 0x44 for little-endian and 0x11 for big-endian. 0 is what old programs
    // leave.
    const unsigned char stamp = head.content[kMarkPlace + 4];
    if (stamp != 0x44 && stamp != 0x11 && stamp != 0)
        refuse_field("MACHST", std::to_string(stamp), "the order of bytes is not known");
    const BinaryHeader header(head.content, stamp == 0x11);
    Image image;
    for (size_t axis = 0; axis < 3; ++axis) {
        image.dims[axis] = header.at<int32_t>(4 * axis);
        if (image.dims[axis] < 1)
            refuse_field("NX, NY, NZ", std::to_string(image.dims[axis]), "an axis must have a voxel");
    }
    image.component = component_of(header);
    check_axes(header);
    set_place(header, image);
    // NSYMBT, word 24: bytes of the extended header, which lies between header and voxels.
    const auto extension = header.at<int32_t>(92);
    if (extension < 0)
        refuse_field("NSYMBT", std::to_string(extension), "it must not be negative");
    VoxelData data;
    data.big_endian = stamp == 0x11;
    data.attached = true;
    data.files = {path};
    data.skip = static_cast<int64_t>(kMrcHeaderBytes) + extension;
    read_voxels(data, image);
    // Only such bytes differ between the two readings of mode 0, so only they need a warning.
    const auto is_high = [](std::byte byte) { return byte >= std::byte{128}; };
    if (size_of(image.component) == 1 && std::any_of(image.voxels.get(), image.voxels.get() + image.bytes(), is_high))
        image.notes.push_back(image.component == Component::int8
                                  ? "its bytes above 127 are taken for negative numbers, as MRC of 2014 has it"
                                  : "its bytes above 127 are taken for positive numbers, as MRC before 2014 has it");
    return image;
}

}  // namespace cleft::io
