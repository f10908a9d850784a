// Numbering along a Hilbert curve.
#include "mesh/order.hpp"

#include "base/collect.hpp"
#include "base/counting_sort.hpp"
#include "base/shared_access.hpp"
#include "base/stage.hpp"
#include "mesh/curve_order.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Items that a thread takes at a time. None of them affects another, so this number changes the time alone.
constexpr int64_t kItemsOrdered = 8192;

Array<int32_t> used_points(const LabelledMesh& mesh, const Run& run)
{
    Array<char> used(mesh.points.size(), 0);
    parallel_for(run, mesh.tets.count(), kItemsOrdered, [&](int64_t begin, int64_t end) {
        for (int64_t t = begin; t < end; ++t)
            for (const int32_t p : mesh.tets[t])
                store_shared(used[p], char{1});
    });
    return collect<int32_t>(run, mesh.points.count(), kItemsOrdered, [&](int64_t begin, int64_t end, auto& points) {
        for (int64_t p = begin; p < end; ++p)
            if (used[p])
                points.push_back(static_cast<int32_t>(p));
    });
}

// The tetrahedra of each point, by their corners.
void sort_each(const Array<Tet>& tets, const Array<uint32_t>& start, Array<int32_t>& order, const Run& run)
{
    const auto less = [&](int32_t a, int32_t b) { return tets[a] < tets[b]; };
    parallel_for(run, start.count() - 1, kItemsOrdered, [&](int64_t begin, int64_t end) {
        for (int64_t p = begin; p < end; ++p)
            std::sort(order.begin() + start[p], order.begin() + start[p + 1], less);
    });
}

// Points of a curve are near each other, so the order of the corners is a spatial order of tetrahedra too.
void order_tets(LabelledMesh& mesh, const Run& run)
{
    CLEFT_ASSERT(mesh.material.size() == mesh.tets.size());
    // By the first corner first, so that threads can sort the few tetrahedra of each point on their own.
    auto [start, order] = group_by_key<uint32_t, int32_t>(
        run, mesh.tets.count(), mesh.points.count(),
        [&](int64_t t, const auto& give) { give(mesh.tets[t][0], static_cast<int32_t>(t)); });
    sort_each(mesh.tets, start, order, run);

    Array<Tet> tets = large_array<Tet>(run, mesh.tets.size());
    Array<Material> material = large_array<Material>(run, mesh.material.size());
    const Array<int32_t>& from = order;
    parallel_for(run, from.count(), kItemsOrdered, [&](int64_t begin, int64_t end) {
        for (int64_t t = begin; t < end; ++t) {
            tets[t] = mesh.tets[from[t]];
            material[t] = mesh.material[from[t]];
        }
    });
    mesh.tets.swap(tets);
    mesh.material.swap(material);
}

}  // namespace

void order_spatially(LabelledMesh& mesh, const Run& run)
{
    Steps steps(run, {{"ordering", 4}, {nullptr, 2}, {nullptr, 4}});
    const Run of_points = steps.next();
    Array<int32_t> order = used_points(mesh, of_points);
    order_along_curve(mesh.points, order, of_points);
    Array<int32_t> new_number(mesh.points.size(), -1);
    Array<Vec3> points = large_array<Vec3>(of_points, order.size(), Vec3::Zero());
    parallel_for(of_points, order.count(), kItemsOrdered, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            new_number[order[i]] = static_cast<int32_t>(i);
            points[i] = mesh.points[order[i]];
        }
    });
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
