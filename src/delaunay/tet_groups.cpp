// A counting sort by the least point, and a small sort in each group.
#include "delaunay/tet_groups.hpp"

#include "base/parallel.hpp"
#include "base/touched_array.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

constexpr int64_t kPointsGrouped = 1 << 14;  // that a thread takes at a time

// Of canonical tetrahedra with one least point.
bool follows_less(const Tet& a, const Tet& b)
{
    const auto two = [](const Tet& t) { return static_cast<uint64_t>(t[1]) << 32 | static_cast<uint32_t>(t[2]); };
    return two(a) != two(b) ? two(a) < two(b) : a[3] < b[3];
}

}  // namespace

// The tetrahedra of a point are those of one part, so that no two threads write to the same counter.
Array<Tet> grouped(Array<Array<Tet>>& parts, int64_t point_count, const Run& run)
{
    Array<int64_t> begin(point_count + 1, 0);
    parallel_for(run, parts.count(), 1, [&](int64_t first, int64_t last) {
        for (int64_t part = first; part < last; ++part)
            for (const Tet& tet : parts[part])
                ++begin[tet[0] + 1];
    });
    for (int64_t v = 0; v < point_count; ++v)
        begin[v + 1] += begin[v];
    Array<Tet> tets = large_array<Tet>(run, begin[point_count]);
    Array<int64_t> next(begin.begin(), begin.end());
    parallel_for(run, parts.count(), 1, [&](int64_t first, int64_t last) {
        for (int64_t part = first; part < last; ++part) {
            for (const Tet& tet : parts[part])
                tets[next[tet[0]]++] = tet;
            parts[part] = Array<Tet>();
        }
    });
    parallel_for(run, point_count, kPointsGrouped, [&](int64_t first, int64_t last) {
        for (int64_t v = first; v < last; ++v)
            std::sort(tets.begin() + begin[v], tets.begin() + begin[v + 1], follows_less);
    });
    return tets;
}

}  // namespace cleft
