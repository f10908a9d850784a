// Reads uncompressed BMP pictures with a palette: the number in the palette is the label.
#include "base/counted.hpp"
#include "base/error.hpp"
#include "io/binary_header.hpp"
#include "io/byte_source.hpp"
#include "io/image_readers.hpp"
#include "io/packed_bits.hpp"

#include <cstdlib>
#include <cstring>
#include <vector>

namespace cleft::io
{

namespace
{

// BITMAPFILEHEADER, then BITMAPCOREHEADER (12 bytes) or BITMAPINFOHEADER and its longer successors, which begin alike.
constexpr size_t kFileHeaderBytes = 14;
constexpr uint32_t kOldestHeader = 12;  // of OS/2, whose sizes are of 16 bits
constexpr uint32_t kCommonHeader = 40;

struct Header {
    uint32_t offset = 0;  // of the voxels
    int64_t width = 0;
    int64_t height = 0;  // negative: the first row is the uppermost
    unsigned bits = 0;
    uint32_t compression = 0;
};

Header parse(const FileHead& head)
{
    const BinaryHeader fields(head.bytes, false);
    const uint32_t header_bytes = fields.at<uint32_t>(kFileHeaderBytes);
    Header header;
    // bfOffBits: other programs leave gaps behind the palette, so the place is not computed.
    header.offset = fields.at<uint32_t>(10);
    if (header_bytes == kOldestHeader) {
        header.width = fields.at<uint16_t>(18);
        header.height = fields.at<uint16_t>(20);
        header.bits = fields.at<uint16_t>(24);
    } else if (header_bytes >= kCommonHeader) {
        header.width = fields.at<int32_t>(18);
        header.height = fields.at<int32_t>(22);
        header.bits = fields.at<uint16_t>(28);
        header.compression = fields.at<uint32_t>(30);
    } else {
        throw Error(CLEFT_ERROR_FORMAT, "its header has " + counted(header_bytes, "byte") + ", which no BMP has");
    }
    return header;
}

void check(const Header& header)
{
    // Colours cannot be turned into labels without guessing; a palette has numbers.
    if (header.bits == 16 || header.bits == 24 || header.bits == 32)
        throw Error(CLEFT_ERROR_FORMAT, "it has colours (" + std::to_string(header.bits) +
                                            " bits a voxel); a palette of at most 8 bits is wanted");
    // 2 bits are of Windows CE; the others are in the definition of BITMAPINFOHEADER.
    if (header.bits != 1 && header.bits != 2 && header.bits != 4 && header.bits != 8)
        throw Error(CLEFT_ERROR_FORMAT, "it has " + std::to_string(header.bits) + " bits a voxel, which no BMP has");
    // BI_RLE8 and BI_RLE4 may leave pixels out, which then have no number.
    if (header.compression != 0)
        throw Error(CLEFT_ERROR_FORMAT, "it is compressed (number " + std::to_string(header.compression) +
                                            "): save it uncompressed, or as PNG");
    if (header.width < 1 || header.height == 0)
        throw Error(CLEFT_ERROR_FORMAT, "it has no voxels");
}

}  // namespace

bool is_bmp(const FileHead& head) { return !head.gzip && head.begins_with("BM"); }

Image read_bmp(const std::string& path, const FileHead& head)
{
    const Header header = parse(head);
    check(header);
    Image image;
    image.dims = {header.width, std::abs(header.height), 1};
    // Rows are padded to a multiple of 4 bytes.
    const auto row_bytes = static_cast<uint64_t>((header.width * header.bits + 31) / 32 * 4);
    ByteSource source(path, Coding::plain);
    source.skip(header.offset);
    // Before memory is taken: a header of 54 bytes may claim 2^31 rows and columns.
    source.expect(row_bytes * static_cast<uint64_t>(image.dims[1]));
    allocate_voxels(image);
    std::vector<unsigned char> row(row_bytes);
    for (int64_t r = 0; r < image.dims[1]; ++r) {
        source.read(row.data(), row.size());
        // A positive biHeight stores the lowest row first; the first row of the volume is the
        // uppermost, as in PNG.
        const int64_t place = header.height > 0 ? image.dims[1] - 1 - r : r;
        std::byte* to = image.voxels.get() + place * image.dims[0];
        if (header.bits < 8)
            unpack_bits(row.data(), header.bits, image.dims[0], to);
        else
            std::memcpy(to, row.data(), static_cast<size_t>(image.dims[0]));
    }
    return image;
}

}  // namespace cleft::io
