// Packs rows of numbers. Bytes of one weight lie together, as those of the higher weights hardly change: so the arrays
// of a mesh shrink to a third of what deflate makes of them as they are.
#include "io/view/packed_numbers.hpp"

#include "io/view/base64.hpp"
#include "io/zlib_stream.hpp"

namespace cleft::io
{

namespace
{

// Higher levels take several times as long and gain a hundredth.
constexpr int kPageLevel = 6;

// Without a branch, and so that small differences of both signs have zeros in their higher bytes.
uint32_t unsigned_difference(int32_t a, int32_t b)
{
    const uint32_t difference = static_cast<uint32_t>(a) - static_cast<uint32_t>(b);
    return difference << 1 ^ (0U - (difference >> 31));
}

std::string planes_of(const std::vector<int32_t>& numbers, size_t columns, Differences differences, const Run& run)
{
    const size_t count = numbers.size();
    std::string planes(4 * count, '\0');
    for (size_t i = 0; i < count; ++i) {
        run.check_at(i);
        const size_t column = i % columns;
        const bool in_row = column > 0 && differences == Differences::kRow;
        const int32_t before = in_row ? numbers[i - column] : i < columns ? 0 : numbers[i - columns];
        const uint32_t difference = unsigned_difference(numbers[i], before);
        for (size_t plane = 0; plane < 4; ++plane)
            planes[plane * count + i] = static_cast<char>(difference >> 8 * plane & 0xFFU);
    }
    return planes;
}

}  // namespace

std::string pack(const std::vector<int32_t>& numbers, size_t columns, Differences differences, const Run& run)
{
    const std::string planes = planes_of(numbers, columns, differences, run);
    return to_base64(zlib_stream(run, planes.data(), planes.size(), kPageLevel));
}

}  // namespace cleft::io
