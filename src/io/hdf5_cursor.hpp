// The fields of HDF5's structures, one after the other: little-endian numbers of one to eight bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace cleft::io
{

// What stands for "nowhere" in place of an address (HDF5 File Format Specification, "Size of Offsets").
inline constexpr uint64_t kNoHdf5Address = ~uint64_t{0};

// It refers to the bytes and does not own them. A structure that ends too early is an Error(CLEFT_ERROR_FORMAT).
class Hdf5Cursor
{
public:
    explicit Hdf5Cursor(std::string_view bytes) : bytes_(bytes) {}

    size_t place() const { return place_; }
    size_t left() const { return bytes_.size() - place_; }

    std::string_view take(uint64_t bytes)
    {
        if (bytes > left())
            damaged();
        const std::string_view taken = bytes_.substr(place_, bytes);
        place_ += bytes;
        return taken;
    }
    void skip(uint64_t bytes) { take(bytes); }
    // Of at most eight bytes.
    uint64_t number(uint64_t bytes)
    {
        uint64_t value = 0;
        int shift = 0;
        for (const char byte : take(bytes)) {
            value |= uint64_t{static_cast<unsigned char>(byte)} << shift;
            shift += 8;
        }
        return value;
    }
    uint64_t byte() { return number(1); }
    uint64_t address() { return number(8); }
    // The version of a structure, which must be in least .. greatest.
    uint64_t version(uint64_t least, uint64_t greatest, const char* structure);
    // The four letters with which some structures begin.
    void expect(std::string_view mark)
    {
        if (take(mark.size()) != mark)
            damaged();
    }

    [[noreturn]] static void damaged();

private:
    std::string_view bytes_;
    size_t place_ = 0;
};

}  // namespace cleft::io
