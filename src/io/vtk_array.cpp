// Decodes the arrays of VTK's XML files. Each length in them comes from the file and is checked
// against the bytes that are there.
#include "io/vtk_array.hpp"

#include "base/counted.hpp"
#include "base/error.hpp"
#include "io/byte_source.hpp"
#include "io/packed_bytes.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace cleft::io
{

namespace
{

[[noreturn]] void damaged(const XmlTag& array, const std::string& what)
{
    throw Error(CLEFT_ERROR_FORMAT, "the array '" + array.get("Name") + "' " + what);
}

int base64_digit(char c)
{
    if (c >= 'A' && c <= 'Z')
        return c - 'A';
    if (c >= 'a' && c <= 'z')
        return c - 'a' + 26;
    if (c >= '0' && c <= '9')
        return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

// Decodes as many bytes as the text gives, at most `bytes`, and moves past them. A piece is padded to three bytes.
std::string take_base64(const XmlTag& array, std::string_view& text, uint64_t bytes)
{
    std::string piece;
    // The claim of the file alone must not take memory.
    piece.reserve(std::min<uint64_t>(bytes, text.size()) + 2);
    while (piece.size() < bytes) {
        int bits = 0;
        for (int i = 0; i < 4; ++i) {
            // Writers break base64 into lines.
            const size_t at = text.find_first_not_of(" \t\r\n");
            if (at == std::string_view::npos)
                damaged(array, "is cut short");
            // Padding counts as zero bits. resize() below drops what it adds.
            const int digit = text[at] == '=' ? 0 : base64_digit(text[at]);
            if (digit < 0)
                damaged(array, "is no base64");
            bits = bits << 6 | digit;
            text.remove_prefix(at + 1);
        }
        for (const int shift : {16, 8, 0})
            piece.push_back(static_cast<char>(bits >> shift & 255));
    }
    piece.resize(bytes);
    return piece;
}

// The stored form of an array: in base64 or raw.
// It is small and copied freely: a copy reads ahead without moving the original.
struct Stored {
    const XmlTag& array;
    std::string_view text;
    bool base64;
    bool wide;  // headers of uint64

    size_t width() const { return wide ? 8 : 4; }

    std::string take(uint64_t bytes)
    {
        if (base64)
            return take_base64(array, text, bytes);
        if (bytes > text.size())
            damaged(array, "is cut short");
        const std::string piece(text.substr(0, bytes));
        text.remove_prefix(bytes);
        return piece;
    }

    // The first bytes, without moving past them.
    std::string look(uint64_t bytes) const { return Stored(*this).take(bytes); }

    uint64_t header_item(const std::string& header, size_t index) const
    {
        uint64_t value = 0;
        std::memcpy(&value, header.data() + index * width(), width());
        return value;
    }
};

// A header with the number of bytes, then the bytes, coded as one piece.
std::string read_plain(const Stored& stored)
{
    const uint64_t bytes = stored.header_item(stored.look(stored.width()), 0);
    // Base64 has four characters for three bytes, so the text is longer than the bytes in either
    // form.
    if (bytes > stored.text.size())
        damaged(stored.array, "is cut short");
    return stored.look(stored.width() + bytes).substr(stored.width());
}

// See compress_blocks(); header and blocks are two pieces.
std::string read_compressed(Stored stored)
{
    const uint64_t blocks = stored.header_item(stored.look(stored.width()), 0);
    // Each block has a number in the header, so there cannot be more blocks than characters.
    if (blocks > stored.text.size())
        damaged(stored.array, "has a damaged header");
    const std::string header = stored.take((3 + blocks) * stored.width());
    const uint64_t block_bytes = stored.header_item(header, 1);
    const uint64_t last_bytes = stored.header_item(header, 2);
    std::string bytes;
    uint64_t packed_bytes = 0;
    for (uint64_t b = 0; b < blocks; ++b) {
        const uint64_t size = stored.header_item(header, 3 + b);
        // Written without a sum of two numbers of the file, which could wrap around.
        if (size > stored.text.size() - std::min<uint64_t>(packed_bytes, stored.text.size()))
            damaged(stored.array, "is cut short");
        packed_bytes += size;
    }
    const std::string packed = stored.take(packed_bytes);
    for (uint64_t b = 0, at = 0; b < blocks; ++b) {
        // A last size of 0 means that the last block is full.
        const uint64_t size = b + 1 == blocks && last_bytes > 0 ? last_bytes : block_bytes;
        const uint64_t packed_size = stored.header_item(header, 3 + b);
        // Before memory is taken for the block.
        if (size / kGreatestDeflateRatio > packed_size)
            damaged(stored.array, "has a damaged header");
        bytes.resize(bytes.size() + size);
        if (!unpack_zlib({packed.data() + at, packed_size}, bytes.data() + bytes.size() - size, size))
            damaged(stored.array, "cannot be inflated");
        at += packed_size;
    }
    return bytes;
}

std::string read_bytes(const XmlTag& array, const VtkEncoding& encoding)
{
    Stored stored{array, array.text, true, encoding.wide_headers};
    if (array.get("format") == "appended") {
        // From the underscore, which is not counted.
        uint64_t offset = 0;
        const std::string number = array.get("offset");
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), offset);
        if (error != std::errc() || end != number.data() + number.size() || offset > encoding.appended.size())
            damaged(array, "lies outside of the file");
        stored.text = encoding.appended.substr(offset);
        stored.base64 = encoding.appended_base64;
    }
    return encoding.compressed ? read_compressed(stored) : read_plain(stored);
}

template <class To>
std::vector<To> parse_text(const XmlTag& array)
{
    std::vector<To> numbers;
    const char* at = array.text.data();
    const char* end = at + array.text.size();
    for (;;) {
        at = std::find_if(at, end, [](char c) { return c != ' ' && c != '\n' && c != '\t' && c != '\r'; });
        if (at == end)
            return numbers;
        To number{};
        const auto [stop, error] = std::from_chars(at, end, number);
        if (error != std::errc())
            damaged(array, "holds '" + std::string(at, std::min<size_t>(20, static_cast<size_t>(end - at))) +
                               "', which is no such number");
        numbers.push_back(number);
        at = stop;
    }
}

template <class From, class To>
std::vector<To> convert(const std::string& bytes)
{
    std::vector<To> numbers(bytes.size() / sizeof(From));
    for (size_t i = 0; i < numbers.size(); ++i) {
        From number;
        std::memcpy(&number, bytes.data() + i * sizeof(From), sizeof(From));
        numbers[i] = static_cast<To>(number);
    }
    return numbers;
}

template <class To>
std::vector<To> convert_any(const XmlTag& array, const std::string& bytes)
{
    // The names of "VTK File Formats". Arrays of String and Bit are not asked for.
    const std::string type = array.get("type");
    if (type == "Int8")
        return convert<int8_t, To>(bytes);
    if (type == "UInt8")
        return convert<uint8_t, To>(bytes);
    if (type == "Int16")
        return convert<int16_t, To>(bytes);
    if (type == "UInt16")
        return convert<uint16_t, To>(bytes);
    if (type == "Int32")
        return convert<int32_t, To>(bytes);
    if (type == "UInt32")
        return convert<uint32_t, To>(bytes);
    if (type == "Int64")
        return convert<int64_t, To>(bytes);
    if (type == "UInt64")
        return convert<uint64_t, To>(bytes);
    // Offsets and corners in floating point are damage, and would lose digits.
    if constexpr (std::is_floating_point_v<To>) {
        if (type == "Float32")
            return convert<float, To>(bytes);
        if (type == "Float64")
            return convert<double, To>(bytes);
    }
    damaged(array, "has the unexpected type '" + type + "'");
}

template <class To>
std::vector<To> read_numbers(const XmlTag& array, const VtkEncoding& encoding, int64_t count)
{
    std::vector<To> numbers =
        array.get("format") == "ascii" ? parse_text<To>(array) : convert_any<To>(array, read_bytes(array, encoding));
    // Counts are those of the piece. A wrong length would shift the labels of all cells.
    if (static_cast<int64_t>(numbers.size()) != count)
        damaged(array, "has " + counted(static_cast<int64_t>(numbers.size()), "number") + " instead of " +
                           std::to_string(count));
    return numbers;
}

}  // namespace

VtkEncoding vtk_encoding_of(const XmlTag& file)
{
    const std::string compressor = file.get("compressor");
    // No program on today's machines writes it, so the code for it could not be tested with real
    // files.
    if (file.get("byte_order") == "BigEndian")
        throw Error(CLEFT_ERROR_UNSUPPORTED, "big-endian arrays cannot be read");
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
        throw Error(CLEFT_ERROR_UNSUPPORTED, "arrays compressed by " + compressor + " cannot be read");
    VtkEncoding encoding;
    encoding.compressed = !compressor.empty();
    // "UInt32" is the default of "VTK File Formats" where the attribute is missing.
    encoding.wide_headers = file.get("header_type") == "UInt64";
    return encoding;
}

void find_vtk_appended_data(std::string_view text, const XmlTag& tag, VtkEncoding& encoding)
{
    // The underscore marks the first byte of the data and is not part of them.
    const size_t begin = text.find('_', tag.end);
    if (begin == std::string_view::npos)
        throw Error(CLEFT_ERROR_FORMAT, "the appended data are missing");
    encoding.appended_base64 = tag.get("encoding") == "base64";
    encoding.appended = text.substr(begin + 1);
}

std::vector<double> read_vtk_reals(const XmlTag& array, const VtkEncoding& encoding, int64_t count)
{
    return read_numbers<double>(array, encoding, count);
}

std::vector<int64_t> read_vtk_integers(const XmlTag& array, const VtkEncoding& encoding, int64_t count)
{
    return read_numbers<int64_t>(array, encoding, count);
}

}  // namespace cleft::io
