// Sums over the triangles at each point: the normal equations of least squares, which the volume corrector solves.
#include "fitting/residuals.hpp"

#include "base/collect.hpp"
#include "base/shared_access.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Points or triangles that a thread takes. The number changes the time alone: the triangles at a point are added in
// their order.
constexpr int64_t kAtOnce = 2048;

// Of a triangle.
struct Left {
    Vec3 normal;
    double area;
    double height;  // what its corners have not moved yet
};

Left left_of(const LocalMesh& mesh, const InterfaceTriangle& t, const Array<FitPoint>& points)
{
    const Vec3 along = area_vector(mesh, t);
    Left left{along.normalized(), along.norm(), t.height + t.offset};
    for (const int32_t p : t.fit_points)
        // A corner that moves along the normal lifts the mean of the triangle by a third of that.
        left.height -= points[p].moved.dot(left.normal) / 3;
    return left;
}

}  // namespace

Array<FitPoint> find_points(const LocalMesh& mesh, const Array<int32_t>& without_tie,
                            Array<InterfaceTriangle>& triangles, const Run& run)
{
    // A mark, and later the place among the points.
    Array<int32_t> index = large_array<int32_t>(run, mesh.point_count(), 0);
    parallel_for(run, triangles.count(), kAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i)
            for (const int32_t v : triangles[i].corners)
                store_shared(index[v], 1);
    });
    auto points = collect<FitPoint>(run, mesh.point_count(), kAtOnce, [&](int64_t begin, int64_t end, auto& list) {
        for (auto v = static_cast<int32_t>(begin); v < end; ++v)
            if (index[v] == 1)
                list.push_back({v});
    });
    parallel_for(run, points.count(), kAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i)
            index[points[i].number] = static_cast<int32_t>(i);
    });
    parallel_for(run, triangles.count(), kAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i)
            for (size_t k = 0; k < 3; ++k)
                triangles[i].fit_points[k] = index[triangles[i].corners[k]];
    });
    Array<int32_t> fixed = without_tie;
    std::sort(fixed.begin(), fixed.end());
    if (!fixed.empty())
        for (FitPoint& p : points)
            p.is_fixed = std::binary_search(fixed.begin(), fixed.end(), p.number);
    return points;
}

TrianglesAt triangles_at(const Array<InterfaceTriangle>& triangles, const Array<FitPoint>& points, const Run& run)
{
    return group_by_key<int64_t, int32_t>(run, triangles.count(), points.count(), [&](int64_t t, const auto& give) {
        for (const int32_t p : triangles[t].fit_points)
            give(p, static_cast<int32_t>(t));
    });
}

Array<Residual> find_residuals(const LocalMesh& mesh, const Array<InterfaceTriangle>& triangles, const TrianglesAt& at,
                               const Array<FitPoint>& points, const Run& run)
{
    Array<Left> left = large_array<Left>(run, triangles.size());
    parallel_for(run, triangles.count(), kAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t t = begin; t < end; ++t)
            left[t] = left_of(mesh, triangles[t], points);
    });
    Array<Residual> out = large_array<Residual>(run, points.size());
    parallel_for(run, points.count(), kAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t p = begin; p < end; ++p)
            for (int64_t i = at.start[p]; i < at.start[p + 1]; ++i) {
                const auto& [normal, area, height] = left[at.values[i]];
                out[p].normals += area * normal * normal.transpose();
                out[p].heights += area * height * normal;
                out[p].area += area;
            }
    });
    return out;
}

}  // namespace cleft
