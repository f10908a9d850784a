// Looks for points that are not finite or at one place, and for tetrahedra that are flat or inverted.
#include "checking/quick_check.hpp"

#include "base/counting_sort.hpp"
#include "base/ordinal.hpp"
#include "mesh/predicates.hpp"

#include <algorithm>
#include <cstring>

namespace cleft
{

namespace
{

// Items per chunk. The least fault of all chunks is the same for every number, so it trades only time: larger chunks
// look further behind a fault.
constexpr int64_t kQuickGrain = 4096;

// The least index that is at fault, or -1.
template <class IsFault>
int64_t first_that(int64_t count, const Run& run, const IsFault& is_fault)
{
    Array<int64_t> first(chunk_count(count, kQuickGrain), -1);
    parallel_chunks(run, count, kQuickGrain, [&](int64_t chunk, int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end && first[chunk] < 0; ++i)
            if (is_fault(i))
                first[chunk] = i;
    });
    const auto found = std::find_if(first.begin(), first.end(), [](int64_t i) { return i >= 0; });
    return found == first.end() ? -1 : *found;
}

uint64_t mixed(uint64_t x)
{
    x ^= x >> 31;
    x *= 0x9e3779b97f4a7c15u;
    return x ^ x >> 29;
}

}  // namespace

uint64_t hash_of_place(const Vec3& point)
{
    uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double x = point[axis] + 0.0;  // no negative zero
        uint64_t bits = 0;
        std::memcpy(&bits, &x, sizeof bits);
        hash = mixed(hash + bits);
    }
    return hash;
}

bool is_before(const Vec3& a, const Vec3& b)
{
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

namespace
{

// Whether two hashes are equal. By their first bits first, so that threads can sort the few that share them.
bool has_equal_hashes(const Array<Vec3>& points, const Run& run)
{
    constexpr int kFirstBits = 12;
    constexpr int64_t kKeysAtOnce = 16;
    constexpr int64_t kKeys = int64_t{1} << kFirstBits;
    Array<uint64_t> hashes = large_array<uint64_t>(run, points.count());
    parallel_for(run, points.count(), kQuickGrain, [&](int64_t begin, int64_t end) {
        std::transform(points.begin() + begin, points.begin() + end, hashes.begin() + begin, hash_of_place);
    });
    Groups<int64_t, uint64_t> groups = group_by_key<int64_t, uint64_t>(
        run, points.count(), kKeys,
        [&](int64_t i, const auto& give) { give(static_cast<int64_t>(hashes[i] >> (64 - kFirstBits)), hashes[i]); });
    std::atomic<bool> has_equal{false};
    parallel_for(run, kKeys, kKeysAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t key = begin; key < end; ++key) {
            const auto first = groups.values.begin() + groups.start[key],
                       last = groups.values.begin() + groups.start[key + 1];
            std::sort(first, last);
            if (std::adjacent_find(first, last) != last)
                has_equal = true;
        }
    });
    return has_equal;
}

// The later of two points at one place, or -1. Points of different hashes are at different places; where hashes are
// equal, which is next to never for different points, all are sorted.
// Sorting hashes needs a third of the memory of sorting coordinates, and compares one number instead of three.
int64_t repeated_point(const Array<Vec3>& points, const Run& run)
{
    if (!has_equal_hashes(points, run))
        return -1;
    Array<size_t> order(points.size());
    for (size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return is_before(points[a], points[b]); });
    const auto twice = std::adjacent_find(order.begin(), order.end(),
                                          [&](size_t a, size_t b) { return !is_before(points[a], points[b]); });
    return twice == order.end() ? -1 : static_cast<int64_t>(*(twice + 1));
}

}  // namespace

std::string quick_fault(const Array<Vec3>& points, const Array<Tet>& tets, const Run& run)
{
    // In this order, because the later checks are exact for finite coordinates only.
    const int64_t wild = first_that(points.count(), run, [&](int64_t i) { return !points[i].allFinite(); });
    if (wild >= 0)
        return "the " + ordinal(wild) + " point is not finite";
    const int64_t twice = repeated_point(points, run);
    if (twice >= 0)
        return "the " + ordinal(twice) + " point is at the place of another";
    const int64_t turned = first_that(tets.count(), run, [&](int64_t t) {
        const auto corner = [&](size_t i) -> const Vec3& { return points[tets[t][i]]; };
        return orient_sign(corner(0), corner(1), corner(2), corner(3)) <= 0;
    });
    return turned < 0 ? "" : "the " + ordinal(turned) + " tetrahedron is flat or inverted";
}

}  // namespace cleft
