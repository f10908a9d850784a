// Measures one tetrahedron by the formulas of docs/method.md.
#include "io/tet_shape.hpp"

#include <algorithm>
#include <limits>

namespace cleft::io
{

namespace
{

double norm(const Vector3& a) { return std::sqrt(dot(a, a)); }

double six_volumes(const Corners& c) { return dot(minus(c[1], c[0]), cross(minus(c[2], c[0]), minus(c[3], c[0]))); }

// Of the faces, all outwards or all inwards, each as long as two of the face; face i is opposite corner i.
std::array<Vector3, 4> normals_of(const Corners& c)
{
    const Vector3 u = minus(c[1], c[0]), v = minus(c[2], c[0]), w = minus(c[3], c[0]);
    return {cross(minus(c[2], c[1]), minus(c[3], c[1])), cross(w, v), cross(u, w), cross(v, u)};
}

}  // namespace

double signed_volume(const Corners& corners) { return six_volumes(corners) / 6; }

AngleCosines angle_cosines(const Corners& corners)
{
    const std::array<Vector3, 4> normals = normals_of(corners);
    AngleCosines found;
    for (size_t i = 0; i < 4; ++i)
        for (size_t j = i + 1; j < 4; ++j) {
            const double lengths = norm(normals[i]) * norm(normals[j]);
            if (!(lengths > 0))
                return {1, -1};
            const double cosine = std::clamp(-dot(normals[i], normals[j]) / lengths, -1.0, 1.0);
            found = {std::max(found.of_least, cosine), std::min(found.of_greatest, cosine)};
        }
    return found;
}

double radius_ratio(const Corners& c)
{
    const Vector3 u = minus(c[1], c[0]), v = minus(c[2], c[0]), w = minus(c[3], c[0]);
    const double volumes = std::abs(six_volumes(c));
    if (!(volumes > 0))
        return std::numeric_limits<double>::infinity();
    double two_areas = 0;
    for (const Vector3& normal : normals_of(c))
        two_areas += norm(normal);
    Vector3 to_centre{};  // of the sphere through the corners, times two of the six volumes
    const Vector3 parts[] = {times(dot(u, u), cross(v, w)), times(dot(v, v), cross(w, u)),
                             times(dot(w, w), cross(u, v))};
    for (size_t axis = 0; axis < 3; ++axis)
        to_centre[axis] = parts[0][axis] + parts[1][axis] + parts[2][axis];
    // The radius inside is three volumes by the area.
    return norm(to_centre) / (2 * volumes) / (3 * volumes / two_areas);
}

double mean_edge(const Corners& corners)
{
    double sum = 0;
    for (size_t i = 0; i < 4; ++i)
        for (size_t j = i + 1; j < 4; ++j)
            sum += norm(minus(corners[j], corners[i]));
    return sum / 6;
}

}  // namespace cleft::io
