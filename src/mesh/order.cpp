// Numbering along a Hilbert curve.
#include "mesh/order.hpp"

#include "base/large_pages.hpp"
#include "base/parallel.hpp"
#include "base/stage.hpp"
#include "mesh/curve_order.hpp"

#include <algorithm>
#include <numeric>

namespace cleft
{

namespace
{

// Items that a thread takes at a time. None of them affects another, so this number changes the time alone.
constexpr int64_t kItemsOrdered = 8192;

Array<int32_t> used_points(const LabelledMesh& mesh)
{
    Array<char> used(mesh.points.size(), 0);
    for (const Tet& tet : mesh.tets)
        for (const int32_t p : tet)
            used[p] = 1;
    Array<int32_t> points;
    points.reserve(mesh.points.size());
    for (size_t p = 0; p < mesh.points.size(); ++p)
        if (used[p])
            points.push_back(static_cast<int32_t>(p));
    return points;
}

// The even permutation that puts the least corner first and the next one second.
// An even permutation keeps the orientation. The first corner then decides the place of the tetrahedron among the
// others.
Tet least_corners_first(Tet t)
{
    const auto swap_two_pairs = [&](int64_t a, int64_t b, int64_t c, int64_t d) {
        std::swap(t[a], t[b]);
        std::swap(t[c], t[d]);
    };
    const auto least = std::min_element(t.begin(), t.end()) - t.begin();
    if (least > 0)
        swap_two_pairs(0, least, least == 1 ? 2 : 1, least == 3 ? 2 : 3);
    std::rotate(t.begin() + 1, std::min_element(t.begin() + 1, t.end()), t.end());
    return t;
}

// Points of a curve are near each other, so the order of the corners is a spatial order of tetrahedra too.
void order_tets(LabelledMesh& mesh, const Run& run)
{
    CLEFT_ASSERT(mesh.material.size() == mesh.tets.size());
    // A counting sort by the first corner first, so that threads can sort the few tetrahedra of each point on their
    // own.
    Array<uint32_t> start(mesh.points.size() + 1, 0);
    for (const Tet& tet : mesh.tets)
        ++start[int64_t{tet[0]} + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    Array<int32_t> order(mesh.tets.size());
    {
        Array<uint32_t> next(start.begin(), start.end() - 1);
        for (size_t t = 0; t < mesh.tets.size(); ++t)
            order[next[mesh.tets[t][0]]++] = static_cast<int32_t>(t);
    }
    const auto less = [&](int32_t a, int32_t b) { return mesh.tets[a] < mesh.tets[b]; };
    parallel_for(run, mesh.points.count(), kItemsOrdered, [&](int64_t begin, int64_t end) {
        for (int64_t p = begin; p < end; ++p)
            std::sort(order.begin() + start[p], order.begin() + start[p + 1], less);
    });

    Array<Tet> tets = large_array<Tet>(mesh.tets.size());
    Array<Material> material = large_array<Material>(mesh.material.size());
    for (size_t t = 0; t < order.size(); ++t) {
        tets[t] = mesh.tets[order[t]];
        material[t] = mesh.material[order[t]];
    }
    mesh.tets.swap(tets);
    mesh.material.swap(material);
}

}  // namespace

void order_spatially(LabelledMesh& mesh, const Run& run)
{
    Steps steps(run, {{"ordering", 4}, {nullptr, 2}, {nullptr, 4}});
    Array<int32_t> order = used_points(mesh);
    order_along_curve(mesh.points, order, steps.next());
    Array<int32_t> new_number(mesh.points.size(), -1);
    Array<Vec3> points;
    reserve_large(points, order.size());
    for (const int32_t p : order) {
        new_number[p] = static_cast<int32_t>(points.size());
        points.push_back(mesh.points[p]);
    }
    mesh.points.swap(points);
    parallel_for(steps.next(), mesh.tets.count(), kItemsOrdered, [&](int64_t begin, int64_t end) {
        for (int64_t t = begin; t < end; ++t) {
            Tet& tet = mesh.tets[t];
            for (int32_t& p : tet)
                p = new_number[p];
            tet = least_corners_first(tet);
        }
    });
    order_tets(mesh, steps.next());
}

}  // namespace cleft
