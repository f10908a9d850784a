// Types are known by their class and their bits; what is not known is of another kind.
#include "io/hdf5_values.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace cleft::io
{

namespace
{

enum : uint64_t { kClassInteger = 0, kClassReal = 1, kClassText = 3 };

bool is_whole_number(Hdf5Cursor properties, uint64_t bytes)
{
    const uint64_t offset = properties.number(2), precision = properties.number(2);
    return offset == 0 && precision == 8 * bytes && (bytes == 1 || bytes == 2 || bytes == 4 || bytes == 8);
}

// Only the two types of IEEE 754 that machines have.
bool is_ieee(Hdf5Cursor properties, uint64_t bytes)
{
    const uint64_t offset = properties.number(2), precision = properties.number(2);
    const uint64_t exponent_at = properties.byte(), exponent = properties.byte();
    const uint64_t mantissa_at = properties.byte(), mantissa = properties.byte();
    const uint64_t bias = properties.number(4);
    const bool is_single =
        bytes == 4 && precision == 32 && exponent_at == 23 && exponent == 8 && mantissa == 23 && bias == 127;
    const bool is_double =
        bytes == 8 && precision == 64 && exponent_at == 52 && exponent == 11 && mantissa == 52 && bias == 1023;
    return offset == 0 && mantissa_at == 0 && (is_single || is_double);
}

template <class From, class To>
void convert_from(bool big_endian, const char* from, uint64_t count, To* to)
{
    for (uint64_t i = 0; i < count; ++i) {
        char raw[sizeof(From)];
        std::memcpy(raw, from + i * sizeof(From), sizeof(From));
        if (big_endian != (__BYTE_ORDER__ == __ORDER_BIG_ENDIAN__))
            std::reverse(raw, raw + sizeof(From));
        From value;
        std::memcpy(&value, raw, sizeof value);
        to[i] = static_cast<To>(value);
    }
}

template <class Signed, class To>
void convert_integers(const Hdf5Type& type, const char* from, uint64_t count, To* to)
{
    if (type.is_signed)
        convert_from<Signed>(type.big_endian, from, count, to);
    else
        convert_from<std::make_unsigned_t<Signed>>(type.big_endian, from, count, to);
}

template <class To>
void convert_any_integers(const Hdf5Type& type, const char* from, uint64_t count, To* to)
{
    if (type.bytes == 1)
        convert_integers<int8_t>(type, from, count, to);
    else if (type.bytes == 2)
        convert_integers<int16_t>(type, from, count, to);
    else if (type.bytes == 4)
        convert_integers<int32_t>(type, from, count, to);
    else
        convert_integers<int64_t>(type, from, count, to);
}

}  // namespace

Hdf5Type hdf5_type(Hdf5Cursor message)
{
    const uint64_t kind = message.byte() & 0x0f;
    const uint64_t bits = message.number(3);
    Hdf5Type type;
    type.bytes = message.number(4);
    if (type.bytes == 0)
        Hdf5Cursor::damaged();
    type.big_endian = (bits & 0x01) != 0;
    if (kind == kClassText) {
        type.kind = Hdf5Kind::text;
    } else if (kind == kClassInteger && is_whole_number(message, type.bytes)) {
        type.kind = Hdf5Kind::integer;
        type.is_signed = (bits & 0x08) != 0;
    } else if (kind == kClassReal && !(bits & 0x40) && is_ieee(message, type.bytes)) {
        type.kind = Hdf5Kind::real;
    }
    return type;
}

std::vector<uint64_t> hdf5_dims(Hdf5Cursor message)
{
    const uint64_t version = message.version(1, 2, "a data space");
    const uint64_t rank = message.byte();
    message.skip(1);
    constexpr uint64_t kNothing = 2;
    if (version == 2 && message.byte() == kNothing)
        return {0};
    message.skip(version == 1 ? 5 : 0);
    std::vector<uint64_t> dims(rank);
    for (uint64_t& dim : dims)
        dim = message.number(8);
    return dims;
}

uint64_t hdf5_count(const std::vector<uint64_t>& dims)
{
    constexpr uint64_t kMost = std::numeric_limits<int64_t>::max();
    uint64_t count = 1;
    for (const uint64_t dim : dims) {
        if (dim > 0 && count > kMost / dim)
            Hdf5Cursor::damaged();
        count *= dim;
    }
    return count;
}

void convert_hdf5(const Hdf5Type& type, const char* from, uint64_t count, double* to)
{
    if (type.kind == Hdf5Kind::integer)
        convert_any_integers(type, from, count, to);
    else if (type.bytes == 4)
        convert_from<float>(type.big_endian, from, count, to);
    else
        convert_from<double>(type.big_endian, from, count, to);
}

void convert_hdf5(const Hdf5Type& type, const char* from, uint64_t count, int64_t* to)
{
    convert_any_integers(type, from, count, to);
}

}  // namespace cleft::io
