// Sums over the triangles at each point: the normal equations of least squares, which the volume corrector solves.
#include "fitting/residuals.hpp"

#include <algorithm>

namespace cleft
{

Array<FitPoint> find_points(const LocalMesh& mesh, const Array<int32_t>& without_tie,
                            Array<InterfaceTriangle>& triangles)
{
    Array<int32_t> index(mesh.point_count(), 0);
    for (const InterfaceTriangle& t : triangles)
        for (const int32_t v : t.corners)
            index[v] = 1;
    Array<FitPoint> points;
    for (int32_t v = 0; v < mesh.point_count(); ++v)
        if (index[v] == 1) {
            index[v] = static_cast<int32_t>(points.size());
            points.push_back({v});
        }
    for (InterfaceTriangle& t : triangles)
        for (size_t i = 0; i < 3; ++i)
            t.fit_points[i] = index[t.corners[i]];
    Array<int32_t> fixed = without_tie;
    std::sort(fixed.begin(), fixed.end());
    for (FitPoint& p : points)
        p.is_fixed = std::binary_search(fixed.begin(), fixed.end(), p.number);
    return points;
}

Array<Residual> find_residuals(const LocalMesh& mesh, const Array<InterfaceTriangle>& triangles,
                               const Array<FitPoint>& points)
{
    Array<Residual> out(points.size());
    for (const InterfaceTriangle& t : triangles) {
        const Vec3 along = area_vector(mesh, t);
        const double area = along.norm();
        const Vec3 normal = along.normalized();
        double height = t.height + t.offset;
        for (const int32_t p : t.fit_points)
            // A corner that moves along the normal lifts the mean of the triangle by a third of that.
            height -= points[p].moved.dot(normal) / 3;
        for (const int32_t p : t.fit_points) {
            Residual& residual = out[p];
            residual.normals += area * normal * normal.transpose();
            residual.heights += area * height * normal;
            residual.area += area;
        }
    }
    return out;
}

}  // namespace cleft
