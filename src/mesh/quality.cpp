#include "mesh/quality.hpp"

#include "mesh/adjacency.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cleft
{

namespace
{

constexpr double kDegrees = 57.295779513082320877;

using Corners = std::array<Vec3, 4>;

// Outward normals of the faces of a positive tetrahedron, twice their areas long; face i is opposite corner i.
std::array<Vec3, 4> face_normals(const Corners& x)
{
    std::array<Vec3, 4> normals;
    for (size_t i = 0; i < 4; ++i) {
        const int* f = kFaceCorners[i];
        const Vec3& a = x[static_cast<size_t>(f[0])];
        normals[i] = (x[static_cast<size_t>(f[1])] - a).cross(x[static_cast<size_t>(f[2])] - a);
    }
    return normals;
}

double squared_edge(const Corners& x, size_t e)
{
    return (x[static_cast<size_t>(kEdgeCorners[e][1])] - x[static_cast<size_t>(kEdgeCorners[e][0])]).squaredNorm();
}

// With faces of areas A, B at an edge of length l, the volume is 2/3 A B sin(angle) / l.
double least_sine(const Corners& x, double six_volumes)
{
    std::array<double, 4> squared_normal;
    const std::array<Vec3, 4> normals = face_normals(x);
    for (size_t i = 0; i < 4; ++i)
        squared_normal[i] = normals[i].squaredNorm();
    double least = std::numeric_limits<double>::infinity();
    for (size_t e = 0; e < 6; ++e) {
        const double product = squared_normal[static_cast<size_t>(kEdgeOpposite[e][0])] *
                               squared_normal[static_cast<size_t>(kEdgeOpposite[e][1])];
        if (!(product > 0))
            return 0;
        least = std::min(least, squared_edge(x, e) / product);
    }
    return six_volumes * std::sqrt(least);
}

// The angle between two faces is atan2 of its sine and cosine, each times the lengths of both normals.
std::array<double, 6> dihedral_angles(const Corners& x, double six_volumes)
{
    const std::array<Vec3, 4> normals = face_normals(x);
    std::array<double, 6> angles;
    for (size_t e = 0; e < 6; ++e) {
        const double cosine =
            -normals[static_cast<size_t>(kEdgeOpposite[e][0])].dot(normals[static_cast<size_t>(kEdgeOpposite[e][1])]);
        angles[e] = kDegrees * std::atan2(std::abs(six_volumes) * std::sqrt(squared_edge(x, e)), cosine);
    }
    return angles;
}

}  // namespace

double least_sine(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    return least_sine({a, b, c, d}, orient(a, b, c, d));
}

std::array<double, 6> dihedral_angles(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    return dihedral_angles({a, b, c, d}, orient(a, b, c, d));
}

double radius_ratio(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    // Circumradius |p| / (2 |6V|), inradius |6V| / (2 sum of areas).
    const Vec3 u = b - a, v = c - a, w = d - a;
    const Vec3 vw = v.cross(w), wu = w.cross(u), uv = u.cross(v);
    const Vec3 p = u.squaredNorm() * vw + v.squaredNorm() * wu + w.squaredNorm() * uv;
    const double areas = (vw.norm() + wu.norm() + uv.norm() + (c - b).cross(d - b).norm()) / 2;
    const double six_volumes = u.cross(v).dot(w);
    return p.norm() * areas / (3 * six_volumes * six_volumes);
}

}  // namespace cleft
