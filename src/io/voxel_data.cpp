// Data behind a header or beside it. Sizes are checked before memory is taken.
#include "io/voxel_data.hpp"

#include "base/counted.hpp"
#include "base/error.hpp"
#include "io/text_scanner.hpp"
#include "io/voxel_access.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <limits>

namespace cleft::io
{

namespace
{

template <class T>
bool store_number(std::string_view word, std::byte* to)
{
    T value{};
    // from_chars() knows no leading plus sign, but C's printf("%+d") writes one.
    const char* begin = word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
    const char* end = word.data() + word.size();
    const auto result = std::from_chars(begin, end, value);
    std::memcpy(to, &value, sizeof value);
    return result.ec == std::errc() && result.ptr == end;
}

bool store_word(std::string_view word, Component component, std::byte* to)
{
    return with_type(component, [&](auto zero) { return store_number<decltype(zero)>(word, to); });
}

// Commas and blanks in any number: hand-written files have both.
bool is_separator(char c) { return c == ' ' || c == ',' || (c >= '\t' && c <= '\r'); }

// The place behind so many lines.
uintmax_t behind_lines(const std::string& path, uintmax_t offset, int64_t lines)
{
    ByteSource source(path, Coding::plain, offset);
    // Lines may be of any length and binary, so bytes are counted and not kept.
    std::vector<char> buffer(size_t{1} << 16);
    for (size_t got = 1; lines > 0;) {
        got = source.read_some(buffer.data(), buffer.size());
        if (got == 0)
            throw Error(CLEFT_ERROR_FORMAT, "it ends within the lines that are to be skipped");
        for (size_t i = 0; i < got && lines > 0; ++i, ++offset)
            lines -= buffer[i] == '\n';
    }
    return offset;
}

ByteSource open_data(const VoxelData& data, const std::string& path, uintmax_t bytes)
{
    const uintmax_t begin = begin_of_voxels(data, path, bytes);
    if (data.encoding != VoxelData::Encoding::deflated)
        return ByteSource(path, Coding::plain, begin);
    return ByteSource(path, Coding::deflated, begin, data.length);
}

// Takes memory when the first file has shown that it can hold its share.
void allocate_once(Image& image)
{
    // A header may name thousands of files that are not there; memory for all voxels is taken when
    // one of them is.
    if (!image.voxels)
        allocate_voxels(image);
}

void read_binary(ByteSource source, size_t begin, size_t bytes, Image& image)
{
    source.expect(bytes);
    allocate_once(image);
    source.read(image.voxels.get() + begin, bytes);
    check_end(source, bytes, image);
}

int hex_digit(char c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

void read_hex(ByteSource source, size_t begin, size_t bytes, Image& image)
{
    // Two digits make a byte.
    source.expect(2 * bytes);
    allocate_once(image);
    const std::string text = source.read_rest();
    size_t at = 0;
    // The next digit; blanks and ends of lines may stand between any two.
    const auto next = [&] {
        while (at < text.size() && is_separator(text[at]))
            ++at;
        if (at == text.size())
            throw Error(CLEFT_ERROR_FORMAT, "its hexadecimal data end too early");
        const int digit = hex_digit(text[at++]);
        if (digit < 0)
            throw Error(CLEFT_ERROR_FORMAT, std::string("'") + text[at - 1] + "' is no hexadecimal digit");
        return digit;
    };
    for (size_t i = 0; i < bytes; ++i) {
        const int high = next();
        image.voxels[begin + i] = static_cast<std::byte>(16 * high + next());
    }
    // More digits than the header tells of mean that its sizes are wrong.
    if (std::any_of(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(),
                    [](char c) { return !is_separator(c); }))
        throw Error(CLEFT_ERROR_FORMAT, "it has more hexadecimal digits than its header tells of");
}

void read_text(ByteSource source, int64_t first, int64_t count, Image& image)
{
    source.expect(2 * static_cast<uintmax_t>(count) - 1);  // a digit each, and blanks between them
    allocate_once(image);
    const std::string text = source.read_rest();
    std::string_view rest = read_text_voxels(text, image, first, count);
    if (std::any_of(rest.begin(), rest.end(), [](char c) { return !is_separator(c); }))
        throw Error(CLEFT_ERROR_FORMAT, "it has more numbers than its header tells of");
    note_text_end(rest.empty(), image);
}

std::string bytes_text(uintmax_t count) { return counted(static_cast<int64_t>(count), "byte"); }

}  // namespace

uintmax_t begin_of_voxels(const VoxelData& data, const std::string& path, uintmax_t bytes)
{
    if (data.offset == -1) {
        // The voxels end with the file. A file that is too short is read from its beginning, so
        // that the error tells how much is missing.
        const uintmax_t size = ByteSource(path, Coding::plain).left();
        return size < bytes ? 0 : size - bytes;
    }
    const auto begin = static_cast<uintmax_t>(data.offset);
    return data.lines > 0 ? behind_lines(path, begin, data.lines) : begin;
}

void judge_surplus(uintmax_t surplus, uintmax_t wanted, Image& image)
{
    // Twice the voxels: the header has forgotten an axis, or halved the type.
    if (surplus >= wanted)
        throw Error(CLEFT_ERROR_FORMAT,
                    "its header tells of " + bytes_text(wanted) + " of voxels, but there are twice as many or more");
    if (surplus > 0)
        image.notes.push_back(bytes_text(surplus) + " behind its voxels " + (surplus == 1 ? "is" : "are") +
                              " not read: is its size right?");
}

void check_end(ByteSource& source, uintmax_t wanted, Image& image)
{
    // Reading on to the end also makes zlib check the sum behind the data.
    std::vector<char> waste(size_t{1} << 16);
    uintmax_t surplus = 0;
    // Not further than as much again, as a damaged header may tell of a few bytes in a file of
    // gigabytes.
    for (size_t got = 1; got > 0 && surplus < wanted; surplus += got)
        got = source.read_some(waste.data(), waste.size());
    judge_surplus(surplus, wanted, image);
    if (surplus == 0 && source.left() > 0)
        image.notes.push_back(bytes_text(source.left()) + " behind its compressed data " +
                              (source.left() == 1 ? "is" : "are") + " not read");
}

void note_text_end(bool within_number, Image& image)
{
    // "12" may be all of a number or the beginning of "127".
    if (within_number)
        image.notes.emplace_back("its last number ends with the file, without an end of the line: is it cut short?");
}

bool is_swapped(bool big_endian) { return big_endian != (__BYTE_ORDER__ == __ORDER_BIG_ENDIAN__); }

void swap_bytes(std::byte* values, size_t count, size_t size)
{
    if (size > 1)
        for (std::byte* at = values; at < values + count * size; at += size)
            std::reverse(at, at + size);
}

void swap_bytes(Image& image)
{
    const size_t size = size_of(image.component);
    swap_bytes(image.voxels.get(), image.bytes() / size, size);
}

std::string beside(const std::string& header, const std::string& name)
{
    // operator/ gives `name` alone where it is absolute.
    return (std::filesystem::path(header).parent_path() / name).string();
}

void store_text_voxel(std::string_view word, Image& image, int64_t voxel)
{
    if (!store_word(word, image.component, image.voxels.get() + static_cast<size_t>(voxel) * size_of(image.component)))
        throw Error(CLEFT_ERROR_FORMAT, "'" + std::string(word.substr(0, 40)) +
                                            "' among its voxels is no number of the type that is given");
}

std::string_view read_text_voxels(std::string_view text, Image& image, int64_t first, int64_t count)
{
    size_t at = 0;
    for (int64_t voxel = first; voxel < first + count; ++voxel) {
        // Words are found here and not by a scanner class, since a text may hold millions of them.
        while (at < text.size() && is_separator(text[at]))
            ++at;
        size_t end = at;
        while (end < text.size() && !is_separator(text[end]))
            ++end;
        if (at == end)
            throw Error(CLEFT_ERROR_FORMAT,
                        "it ends too early: " +
                            counted(static_cast<int64_t>(first + count - voxel), "number is", "numbers are") +
                            " missing");
        store_text_voxel(text.substr(at, end - at), image, voxel);
        at = end;
    }
    return text.substr(at);
}

void read_voxels(const VoxelData& data, Image& image)
{
    const uintmax_t total = checked_bytes(image);
    const uintmax_t size = size_of(image.component);
    const uintmax_t files = data.files.size();
    // Shares are whole numbers of voxels, so no number lies in two files.
    if (files == 0 || total / size % files != 0)
        throw Error(CLEFT_ERROR_FORMAT, "its voxels cannot be shared evenly among " + std::to_string(files) + " files");
    const auto share = static_cast<size_t>(total / files);
    for (size_t f = 0; f < files; ++f) {
        const size_t begin = f * share;
        const auto read = [&] {
            ByteSource source = open_data(data, data.files[f], share);
            // Behind decompression: NRRD defines "byte skip" so for gzip.
            source.skip(static_cast<uintmax_t>(data.skip));
            if (data.encoding == VoxelData::Encoding::text)
                read_text(std::move(source), static_cast<int64_t>(begin / size), static_cast<int64_t>(share / size),
                          image);
            else if (data.encoding == VoxelData::Encoding::hex)
                read_hex(std::move(source), begin, share, image);
            else
                read_binary(std::move(source), begin, share, image);
        };
        // The user named this file already, and the caller adds its name.
        if (data.attached)
            read();
        else
            naming_file(data.files[f], read);
    }
    // Once, at the end: parts of all files lie in one array.
    if (data.encoding != VoxelData::Encoding::text && is_swapped(data.big_endian))
        swap_bytes(image.voxels.get(), static_cast<size_t>(total / size), static_cast<size_t>(size));
}

}  // namespace cleft::io
