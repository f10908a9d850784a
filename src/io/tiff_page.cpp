// Says what a page of a TIFF file holds, refuses by name what is no label map, and decodes the rest by libtiff.
#include "io/tiff_page.hpp"

#include "base/error.hpp"
#include "base/ordinal.hpp"
#include "io/packed_bits.hpp"

#include <algorithm>
#include <cstring>
#include <vector>

namespace cleft::io
{

namespace
{

// The tag's number, or what the standard says where it is missing.
template <class T>
// `otherwise` is for tags without a default in libtiff.
T tag_of(const TiffFile& file, uint32_t tag, T otherwise)
{
    T value{};
    return TIFFGetFieldDefaulted(file.handle(), tag, &value) ? value : otherwise;
}

// Names for the message alone. 33003 and 33005 are Aperio's JPEG 2000, 50002 and 52546 are JPEG XL.
std::string compression_name(unsigned compression)
{
    switch (compression) {
        case COMPRESSION_OJPEG:
            return "old JPEG";
        case COMPRESSION_JPEG:
            return "JPEG";
        case COMPRESSION_LZMA:
            return "LZMA";
        case COMPRESSION_ZSTD:
            return "Zstandard";
        case COMPRESSION_WEBP:
            return "WebP";
        case COMPRESSION_LERC:
            return "LERC";
        case COMPRESSION_JBIG:
            return "JBIG";
        case COMPRESSION_JP2000:
        case 33003:
        case 33005:
            return "JPEG 2000";
        case 50002:
        case 52546:
            return "JPEG XL";
        default:
            return "number " + std::to_string(compression);
    }
}

// The others hold colours, lose what labels need, or have decoders that are not kept.
bool is_readable(unsigned compression)
{
    switch (compression) {
        case COMPRESSION_NONE:
        case COMPRESSION_CCITTRLE:
        case COMPRESSION_CCITTRLEW:
        case COMPRESSION_CCITTFAX3:
        case COMPRESSION_CCITTFAX4:
        case COMPRESSION_LZW:
        case COMPRESSION_JPEG:
        case COMPRESSION_PACKBITS:
        case COMPRESSION_ADOBE_DEFLATE:
        case COMPRESSION_DEFLATE:
        case COMPRESSION_LZMA:
        case COMPRESSION_ZSTD:
        case COMPRESSION_LERC:
            // The installed libtiff may have been built without this codec.
            return TIFFIsCODECConfigured(static_cast<uint16_t>(compression)) != 0;
        default:
            return false;
    }
}

bool is_fax(unsigned compression)
{
    return compression == COMPRESSION_CCITTRLE || compression == COMPRESSION_CCITTRLEW ||
           compression == COMPRESSION_CCITTFAX3 || compression == COMPRESSION_CCITTFAX4;
}

Component integers_of(unsigned bits, bool is_signed)
{
    switch (bits) {
        case 16:
            return is_signed ? Component::int16 : Component::uint16;
        case 32:
            return is_signed ? Component::int32 : Component::uint32;
        case 64:
            return is_signed ? Component::int64 : Component::uint64;
        default:
            return is_signed ? Component::int8 : Component::uint8;
    }
}

Component component_of(unsigned bits, unsigned format)
{
    const std::string width = std::to_string(bits) + " bits";
    // 12 and 24 bits would need unpacking across bytes in both orders, and no label map is known to
    // use them.
    const bool whole_bytes = bits == 8 || bits == 16 || bits == 32 || bits == 64;
    switch (format) {
        case SAMPLEFORMAT_UINT:
            if (whole_bytes || bits == 1 || bits == 2 || bits == 4)
                return integers_of(bits, false);
            break;
        case SAMPLEFORMAT_INT:
            if (whole_bytes)
                return integers_of(bits, true);
            break;
        case SAMPLEFORMAT_IEEEFP:
            if (bits == 32 || bits == 64)
                return bits == 32 ? Component::float32 : Component::float64;
            throw Error(CLEFT_ERROR_FORMAT,
                        "its voxels are floating-point numbers of " + width + "; 32 or 64 are wanted");
        case SAMPLEFORMAT_COMPLEXINT:
        case SAMPLEFORMAT_COMPLEXIEEEFP:
            throw Error(CLEFT_ERROR_FORMAT, "its voxels are complex numbers");
        // TIFF 6.0, section 19: SampleFormat 4, "undefined data format".
        case SAMPLEFORMAT_VOID:
            throw Error(CLEFT_ERROR_FORMAT, "it says of its voxels that their type is not known (SampleFormat 4)");
        default:
            throw Error(CLEFT_ERROR_FORMAT, "its SampleFormat " + std::to_string(format) + " does not exist");
    }
    throw Error(CLEFT_ERROR_FORMAT, "its voxels are " +
                                        std::string(format == SAMPLEFORMAT_INT ? "signed" : "unsigned") +
                                        " numbers of " + width + "; 8, 16, 32 or 64 are wanted");
}

// Refuses what has several numbers a voxel.
void check_samples(const TiffFile& file, unsigned photometric)
{
    const auto samples = tag_of<uint16_t>(file, TIFFTAG_SAMPLESPERPIXEL, 1);
    // PhotometricInterpretation 0, 1, 3 and 4 of TIFF 6.0 have one number a pixel.
    if (photometric != PHOTOMETRIC_MINISWHITE && photometric != PHOTOMETRIC_MINISBLACK &&
        photometric != PHOTOMETRIC_PALETTE && photometric != PHOTOMETRIC_MASK)
        throw Error(CLEFT_ERROR_FORMAT, "it has colours, " + std::to_string(samples) +
                                            " numbers a voxel (PhotometricInterpretation " +
                                            std::to_string(photometric) + "); one is wanted");
    if (samples != 1)
        throw Error(CLEFT_ERROR_FORMAT, "it has " + std::to_string(samples) + " numbers a voxel; one is wanted");
}

void check_compression(const TiffPage& page, const TiffDirectory& directory)
{
    constexpr uint16_t kPredictor = 317;
    if (!is_readable(page.compression))
        throw Error(CLEFT_ERROR_FORMAT, "its compression, " + compression_name(page.compression) +
                                            ", cannot be read: save it uncompressed, or by deflate or LZW");
    // Predictor (TIFF 6.0, section 14) belongs to LZW, deflate and their kin. libtiff ignores it
    // elsewhere, and then gives differences for values.
    const bool predicts = directory.value(kPredictor, 1) != 1;
    if (predicts && (page.compression == COMPRESSION_NONE || page.compression == COMPRESSION_PACKBITS))
        throw Error(CLEFT_ERROR_FORMAT, "it has a predictor, but a compression that knows none");
}

// How many bytes strip or tile `part` becomes.
uint64_t decoded_bytes(const TiffFile& file, const TiffPage& page, uint32_t part)
{
    if (page.tiled)
        return static_cast<uint64_t>(TIFFTileSize64(file.handle()));
    // RowsPerStrip has the default 2^32 - 1: all rows in one strip (TIFF 6.0, section 8).
    const uint64_t rows = std::min<uint64_t>(tag_of<uint32_t>(file, TIFFTAG_ROWSPERSTRIP, UINT32_MAX),
                                             static_cast<uint64_t>(page.height));
    return std::min(rows, static_cast<uint64_t>(page.height) - part * rows) * page.row_bytes();
}

uint32_t part_count(const TiffFile& file, const TiffPage& page)
{
    return page.tiled ? TIFFNumberOfTiles(file.handle()) : TIFFNumberOfStrips(file.handle());
}

void check_parts(const TiffFile& file, const TiffPage& page, uint64_t file_bytes)
{
    const uint32_t parts = part_count(file, page);
    if (parts == 0)
        throw Error(CLEFT_ERROR_FORMAT, "it has no voxels");
    // All parts are looked at before memory is taken for the voxels.
    for (uint32_t part = 0; part < parts; ++part) {
        const uint64_t offset = TIFFGetStrileOffset(file.handle(), part);
        const uint64_t stored = TIFFGetStrileByteCount(file.handle(), part);
        const std::string who = "the " + ordinal(part) + (page.tiled ? " tile" : " strip");
        // Sparse files of GDAL leave out empty tiles. Which number they stand for is not in the
        // file.
        if (stored == 0 || offset == 0)
            throw Error(CLEFT_ERROR_FORMAT, who + " is missing from the file");
        if (offset > file_bytes || stored > file_bytes - offset)
            throw Error(CLEFT_ERROR_FORMAT, who + " lies behind the end of the file: the file is cut short or damaged");
        if (static_cast<double>(decoded_bytes(file, page, part)) > most_expansion(page) * static_cast<double>(stored))
            throw Error(CLEFT_ERROR_FORMAT, who + " has fewer bytes than its voxels need");
    }
}

TiffPage page_of(const TiffFile& file, const TiffDirectory& directory, uint64_t file_bytes)
{
    TiffPage page;
    page.width = tag_of<uint32_t>(file, TIFFTAG_IMAGEWIDTH, 0);
    page.height = tag_of<uint32_t>(file, TIFFTAG_IMAGELENGTH, 0);
    page.bits = tag_of<uint16_t>(file, TIFFTAG_BITSPERSAMPLE, 1);
    page.compression = tag_of<uint16_t>(file, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
    page.tiled = TIFFIsTiled(file.handle()) != 0;
    const auto photometric = tag_of<uint16_t>(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    page.white_is_zero = photometric == PHOTOMETRIC_MINISWHITE;
    // Division by the size of a row follows.
    if (page.width == 0 || page.height == 0)
        throw Error(CLEFT_ERROR_FORMAT, "it has no voxels");
    // Tags of SGI's extension, in which a page is a volume.
    if (tag_of<uint32_t>(file, TIFFTAG_IMAGEDEPTH, 1) != 1 || tag_of<uint32_t>(file, TIFFTAG_TILEDEPTH, 1) != 1)
        throw Error(CLEFT_ERROR_UNSUPPORTED, "it has several slices in one (ImageDepth)");
    check_samples(file, photometric);
    page.component = component_of(page.bits, tag_of<uint16_t>(file, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT));
    check_compression(page, directory);
    check_parts(file, page, file_bytes);
    return page;
}

// What was decoded, copied to where it belongs.
void place_rows(const TiffPage& page, const unsigned char* decoded, uint64_t decoded_row, int64_t rows, int64_t columns,
                std::byte* to)
{
    const size_t row = static_cast<size_t>(page.width) * size_of(page.component);
    for (int64_t r = 0; r < rows; ++r, decoded += decoded_row, to += row)
        if (page.bits < 8)
            unpack_bits(decoded, page.bits, columns, to);
        else
            std::memcpy(to, decoded, static_cast<size_t>(columns) * size_of(page.component));
}

// libtiff goes on after some faults with a word only: any word is a fault here.
void check_decoded(TiffFile& file, tmsize_t got, uint64_t wanted)
{
    const TiffMessages said = file.take_messages();
    if (said.out_of_memory)
        throw std::bad_alloc();
    // A strip that decodes to fewer bytes would leave the rest of the voxels unset.
    if (got < 0 || static_cast<uint64_t>(got) != wanted || !said.error.empty() || !said.warning.empty())
        throw Error(CLEFT_ERROR_FORMAT, "its voxels cannot be decoded: the file is damaged (libtiff: '" +
                                            (said.error.empty() ? said.warning : said.error) + "')");
}

void read_strips(TiffFile& file, const TiffPage& page, std::byte* voxels)
{
    const uint64_t strip_bytes = decoded_bytes(file, page, 0);
    const auto rows = static_cast<int64_t>(strip_bytes / page.row_bytes());
    const size_t row = static_cast<size_t>(page.width) * size_of(page.component);
    // Strips of whole bytes are decoded in place. Packed ones need a buffer.
    std::vector<unsigned char> packed(page.bits < 8 ? strip_bytes : 0);
    for (uint32_t strip = 0; strip < part_count(file, page); ++strip) {
        const uint64_t bytes = decoded_bytes(file, page, strip);
        std::byte* to = voxels + static_cast<size_t>(strip * rows) * row;
        void* decoded = page.bits < 8 ? static_cast<void*>(packed.data()) : to;
        check_decoded(file, TIFFReadEncodedStrip(file.handle(), strip, decoded, static_cast<tmsize_t>(bytes)), bytes);
        if (page.bits < 8)
            place_rows(page, packed.data(), page.row_bytes(), static_cast<int64_t>(bytes / page.row_bytes()),
                       page.width, to);
    }
}

void read_tiles(TiffFile& file, const TiffPage& page, std::byte* voxels)
{
    const int64_t columns = tag_of<uint32_t>(file, TIFFTAG_TILEWIDTH, 0);
    const int64_t rows = tag_of<uint32_t>(file, TIFFTAG_TILELENGTH, 0);
    const auto tile_row = static_cast<uint64_t>(TIFFTileRowSize64(file.handle()));
    const uint64_t bytes = decoded_bytes(file, page, 0);
    std::vector<unsigned char> tile(bytes);
    // TIFF 6.0, section 15: tiles are numbered by rows, from the upper left.
    uint32_t number = 0;
    for (int64_t y = 0; y < page.height; y += rows)
        for (int64_t x = 0; x < page.width; x += columns, ++number) {
            const tmsize_t got = TIFFReadEncodedTile(file.handle(), number, tile.data(), static_cast<tmsize_t>(bytes));
            check_decoded(file, got, bytes);
            // Tiles at the right and lower sides are padded to full size; the padding is dropped.
            place_rows(page, tile.data(), tile_row, std::min(rows, page.height - y), std::min(columns, page.width - x),
                       voxels + static_cast<size_t>(y * page.width + x) * size_of(page.component));
        }
}

template <class Body>
auto naming_page(const std::string& name, const Body& body)
{
    try {
        return body();
    } catch (const Error& error) {
        throw Error(error.status(), name + ": " + error.what());
    }
}

}  // namespace

TiffPage tiff_page(const TiffFile& file, const TiffDirectory& directory, uint64_t file_bytes, const std::string& name)
{
    return naming_page(name, [&] {
        TiffPage page = page_of(file, directory, file_bytes);
        page.name = name;
        return page;
    });
}

double most_expansion(const TiffPage& page)
{
    if (page.compression == COMPRESSION_NONE)
        return 1;
    // Two bytes become 128 (TIFF 6.0, section 9).
    if (page.compression == COMPRESSION_PACKBITS)
        return 64;
    if (page.compression == COMPRESSION_LZW || page.compression == COMPRESSION_DEFLATE ||
        page.compression == COMPRESSION_ADOBE_DEFLATE)
        // Deflate reaches 1032. LZW's codes have up to 12 bits, and their strings grow by one byte
        // each to some 4,000: about 1,400 on average.
        return 1500;
    if (is_fax(page.compression))  // a row that is like the last one takes one bit
        return 8.0 * static_cast<double>(page.row_bytes());
    // Bounds far above what these codecs reach on real data. They only catch claims of terabytes.
    return page.compression == COMPRESSION_LERC ? 1e7 : 1e5;
}

void read_tiff_page(TiffFile& file, const TiffPage& page, std::byte* voxels)
{
    // What libtiff said before is not about these voxels.
    file.take_messages();
    naming_page(page.name, [&] { page.tiled ? read_tiles(file, page, voxels) : read_strips(file, page, voxels); });
}

}  // namespace cleft::io
