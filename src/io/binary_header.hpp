// Numbers at fixed places of a binary header, in either order of bytes.
#pragma once

#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <vector>

namespace cleft::io
{

// It refers to the bytes and does not own them. Reading is by memcpy, since the places in headers
// are not aligned for their types.
class BinaryHeader
{
public:
    // `big_endian` is the order in the file, whatever the machine's own order is.
    BinaryHeader(const std::vector<unsigned char>& bytes, bool big_endian)
        : BinaryHeader(bytes.data(), bytes.size(), big_endian)
    {
    }
    BinaryHeader(const unsigned char* bytes, size_t count, bool big_endian)
        : bytes_(bytes), count_(count), swapped_(big_endian != (__BYTE_ORDER__ == __ORDER_BIG_ENDIAN__))
    {
    }

    // The number of type T at `offset`. Throws Error(CLEFT_ERROR_FORMAT) where the header ends
    // before it.
    template <class T>
    T at(size_t offset) const
    {
        if (offset + sizeof(T) > count_)
            throw Error(CLEFT_ERROR_FORMAT, "its header is cut short");
        unsigned char raw[sizeof(T)];
        std::copy_n(bytes_ + offset, sizeof(T), raw);
        if (swapped_)
            std::reverse(raw, raw + sizeof(T));
        T value;
        std::memcpy(&value, raw, sizeof value);
        return value;
    }

    // As many numbers of type T as `to` has places.
    template <class T, class To, size_t N>
    void at(size_t offset, std::array<To, N>& to) const
    {
        for (size_t i = 0; i < N; ++i)
            to[i] = static_cast<To>(at<T>(offset + i * sizeof(T)));
    }

private:
    const unsigned char* bytes_;
    size_t count_;
    bool swapped_;
};

}  // namespace cleft::io
