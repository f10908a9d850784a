// Numbers at fixed places of a binary header, in either order of bytes.
#pragma once

#include "base/error.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

namespace cleft::io
{

class BinaryHeader
{
public:
    BinaryHeader(const std::vector<unsigned char>& bytes, bool big_endian) : bytes_(bytes), big_endian_(big_endian) {}

    template <class T>
    T at(size_t offset) const
    {
        if (offset + sizeof(T) > bytes_.size())
            throw Error(CLEFT_ERROR_FORMAT, "its header is cut short");
        unsigned char raw[sizeof(T)];
        std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(offset), sizeof(T), raw);
        if (big_endian_ != (__BYTE_ORDER__ == __ORDER_BIG_ENDIAN__))
            std::reverse(raw, raw + sizeof(T));
        T value;
        std::memcpy(&value, raw, sizeof value);
        return value;
    }

private:
    const std::vector<unsigned char>& bytes_;
    bool big_endian_;
};

}  // namespace cleft::io
