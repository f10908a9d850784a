// Numbers of fewer bits than a byte has, the first in the highest bits.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cleft::io
{

// Turns `count` numbers of 1, 2 or 4 bits into bytes.
// `bits` is 1, 2 or 4. `voxels` has room for `count` bytes, `packed` holds count * bits bits,
// rounded up to a byte. The order is that of TIFF with FillOrder 1, and of BMP.
inline void unpack_bits(const unsigned char* packed, unsigned bits, int64_t count, std::byte* voxels)
{
    const unsigned in_byte = 8 / bits;
    const unsigned mask = (1U << bits) - 1;
    for (int64_t i = 0; i < count; ++i) {
        const unsigned shift = bits * (in_byte - 1 - static_cast<unsigned>(i % in_byte));
        voxels[i] = static_cast<std::byte>(packed[i / in_byte] >> shift & mask);
    }
}

}  // namespace cleft::io
