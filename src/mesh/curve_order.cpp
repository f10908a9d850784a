// Keys along a Hilbert curve, and a sort by them.
#include "mesh/curve_order.hpp"

#include "base/counting_sort.hpp"
#include "mesh/bounding_box.hpp"

#include <algorithm>
#include <array>

namespace cleft
{

namespace
{

constexpr int kBits = 21;  // a coordinate: three of them fit 64 bits
// Points that a thread takes at a time. A key depends on its own point, so this number changes the time alone.
constexpr int64_t kPointsKeyed = 8192;

struct Key {
    uint64_t value;
    int32_t index;
};

// The bits of x, each followed by two zeros.
uint64_t spread(uint64_t x)
{
    x = (x | x << 32) & 0x001f00000000ffffu;
    x = (x | x << 16) & 0x001f0000ff0000ffu;
    x = (x | x << 8) & 0x100f00f00f00f00fu;
    x = (x | x << 4) & 0x10c30c30c30c30c3u;
    return (x | x << 2) & 0x1249249249249249u;
}

// Place of a cell of the 2^21 cube along the curve, by Skilling's transform of the coordinates ("Programming the
// Hilbert curve", 2004) and then interleaving their bits. Masks take the place of branches, half of which a processor
// would guess wrongly.
uint64_t hilbert_index(std::array<uint32_t, 3> x)
{
    for (int bit = kBits - 1; bit > 0; --bit) {
        const uint32_t lower = (1u << bit) - 1;
        for (uint32_t& coordinate : x) {
            const uint32_t is_set = 0u - (coordinate >> bit & 1u);
            const uint32_t swapped = (x[0] ^ coordinate) & lower & ~is_set;
            x[0] ^= swapped | (lower & is_set);
            coordinate ^= swapped;
        }
    }
    x[1] ^= x[0];
    x[2] ^= x[1];
    uint32_t flip = 0;
    for (int bit = kBits - 1; bit > 0; --bit)
        flip ^= ((1u << bit) - 1) & (0u - (x[2] >> bit & 1u));
    return spread(x[0] ^ flip) << 2 | spread(x[1] ^ flip) << 1 | spread(x[2] ^ flip);
}

// By the first bits first, so that threads can sort the few that share them. Stable.
Array<Key> sorted(const Array<Key>& keys, const Run& run)
{
    constexpr int kFirstBits = 12;
    constexpr int64_t kFirst = int64_t{1} << kFirstBits;
    constexpr int64_t kFirstAtOnce = 16;
    Groups<int64_t, Key> groups =
        group_by_key<int64_t, Key>(run, keys.count(), kFirst, [&](int64_t k, const auto& give) {
            give(static_cast<int64_t>(keys[k].value >> (3 * kBits - kFirstBits)), keys[k]);
        });
    parallel_for(run, kFirst, kFirstAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t first = begin; first < end; ++first)
            std::stable_sort(groups.values.begin() + groups.start[first],
                             groups.values.begin() + groups.start[first + 1],
                             [](const Key& a, const Key& b) { return a.value < b.value; });
    });
    return std::move(groups.values);
}

// Points of one cell of the curve: by their coordinates, so that the order is that of the places alone.
void sort_ties(const Array<Vec3>& points, Array<Key>& keys)
{
    const auto less = [&](const Key& a, const Key& b) { return comes_first(points[a.index], points[b.index]); };
    for (auto first = keys.begin(), last = first; first != keys.end(); first = last) {
        last = std::find_if(first, keys.end(), [&](const Key& key) { return key.value != first->value; });
        if (last - first > 1)
            std::stable_sort(first, last, less);
    }
}

}  // namespace

uint64_t place_on_curve(const Vec3& x, const BoundingBox& box)
{
    const double cells = static_cast<double>((1u << kBits) - 1);
    const double longest = box.longest();
    // All axes have the scale of the longest side, so that cells are cubes. With cells as flat as the box, points that
    // are neighbours along the curve could be far apart.
    std::array<uint32_t, 3> cell{};
    for (size_t axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<Eigen::Index>(axis);
        cell[axis] = longest > 0 ? static_cast<uint32_t>((x[a] - box.lo[a]) / longest * cells) : 0;
    }
    return hilbert_index(cell);
}

bool comes_first(const Vec3& x, const Vec3& y)
{
    return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end());
}

void order_along_curve(const Array<Vec3>& points, Array<int32_t>& indices, const Run& run)
{
    const auto point = [&](int32_t index) -> const Vec3& { return points[index]; };
    BoundingBox box;
    for (const int32_t index : indices)
        box.add(point(index));
    Array<Key> keys = large_array<Key>(run, indices.size());
    parallel_for(run, keys.count(), kPointsKeyed, [&](int64_t begin, int64_t end) {
        for (int64_t k = begin; k < end; ++k)
            keys[k] = {place_on_curve(point(indices[k]), box), indices[k]};
    });
    keys = sorted(keys, run);
    sort_ties(points, keys);
    std::transform(keys.begin(), keys.end(), indices.begin(), [](const Key& key) { return key.index; });
}

}  // namespace cleft
