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
        for (int32_t& v : t.corners)
            v = index[v];
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
    const auto place = [&](int32_t i) -> const Vec3& { return mesh.point(points[i].number); };
    for (const InterfaceTriangle& t : triangles) {
        const Vec3& a = place(t.corners[0]);
        const Vec3 twice = (place(t.corners[1]) - a).cross(place(t.corners[2]) - a);
        const double area = 0.5 * twice.norm();
        const Vec3 normal = twice.normalized();
        double height = t.height + t.offset;
        for (const int32_t v : t.corners)
            // A corner that moves along the normal lifts the mean of the triangle by a third of that.
            height -= points[v].moved.dot(normal) / 3;
        for (const int32_t v : t.corners) {
            Residual& residual = out[v];
            residual.normals += area * normal * normal.transpose();
            residual.heights += area * height * normal;
            residual.area += area;
        }
    }
    return out;
}

}  // namespace cleft
