// Numbers the edges of a mesh.
#include "mesh/quadratic.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// In the order of QuadraticTet; kEdgeCorners has another one.
constexpr size_t kEnds[6][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}};

uint64_t edge_of(const Tet& tet, size_t edge)
{
    const int32_t a = tet[kEnds[edge][0]], b = tet[kEnds[edge][1]];
    return static_cast<uint64_t>(std::min(a, b)) << 32 | static_cast<uint32_t>(std::max(a, b));
}

}  // namespace

MiddleNodes::MiddleNodes(const Array<Tet>& tets)
{
    edges_.reserve(6 * tets.size());
    for (const Tet& tet : tets)
        for (size_t edge = 0; edge < 6; ++edge)
            edges_.push_back(edge_of(tet, edge));
    // Sorting makes the numbers of nodes follow from those of the points alone, in whatever order tetrahedra come.
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
}

Vec3 MiddleNodes::place(size_t middle, const Array<Vec3>& points) const
{
    const uint64_t edge = edges_[middle];
    return 0.5 * (points[edge >> 32] + points[edge & 0xffffffffU]);
}

QuadraticTet MiddleNodes::nodes(const Tet& tet, size_t point_count) const
{
    QuadraticTet out{};
    std::copy(tet.begin(), tet.end(), out.begin());
    for (size_t edge = 0; edge < 6; ++edge) {
        const auto found = std::lower_bound(edges_.begin(), edges_.end(), edge_of(tet, edge)) - edges_.begin();
        CLEFT_ASSERT(edges_[found] == edge_of(tet, edge));
        out[4 + edge] = static_cast<int32_t>(int64_t(point_count) + found);
    }
    return out;
}

}  // namespace cleft
