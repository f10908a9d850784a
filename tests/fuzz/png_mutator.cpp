// Gives each part of a damaged PNG its right check sum again: with a wrong one, libpng looks no further.
#include <zlib.h>
#include <cstddef>
#include <cstdint>

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t most);
extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t most, unsigned int seed);

namespace
{

constexpr size_t signature = 8;
constexpr size_t around = 12;  // length, name and sum of a part

uint32_t number_at(const uint8_t* at)
{
    return uint32_t{at[0]} << 24 | uint32_t{at[1]} << 16 | uint32_t{at[2]} << 8 | uint32_t{at[3]};
}

}  // namespace

size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t most, unsigned int)
{
    const size_t made = LLVMFuzzerMutate(data, size, most);
    size_t at = signature;
    while (made >= at + around && number_at(data + at) <= made - at - around) {
        const uint32_t length = number_at(data + at);
        const auto sum = static_cast<uint32_t>(crc32(0, data + at + 4, length + 4));
        for (size_t i = 0; i < 4; ++i)
            data[at + 8 + length + i] = static_cast<uint8_t>(sum >> (24 - 8 * i));
        at += around + length;
    }
    return made;
}
