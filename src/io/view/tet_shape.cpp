// Measures one tetrahedron by the formulas of docs/method.md. The library gives measures of whole meshes only.
#include "io/view/tet_shape.hpp"

#include <algorithm>
#include <limits>

namespace cleft::io
{

namespace
{

constexpr double kDegrees = 180 / 3.14159265358979323846;

Vector3 plus(const Vector3& a, const Vector3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

// The angle at the edge from a to b, between the faces that go to c and to d.
double dihedral(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
    const Vector3 edge = minus(b, a);
    const Vector3 first = cross(edge, minus(c, a));
    const Vector3 second = cross(edge, minus(d, a));
    // atan2 keeps its digits near 0 and 180 degrees, where acos loses half of them.
    return kDegrees * std::atan2(length(cross(first, second)), dot(first, second));
}

// With the volume V and the area A of all faces the inradius is 3 V / A. The circumcentre lies at n / (12 V) from the
// first corner, where n is the sum below.
double radius_ratio(const Vector3& a, const Vector3& b, const Vector3& c, double volume)
{
    const Vector3 sides[] = {cross(b, c), cross(c, a), cross(a, b), cross(minus(b, a), minus(c, a))};
    double area = 0;
    for (const Vector3& side : sides)
        area += length(side) / 2;
    const Vector3 n = plus(plus(times(dot(a, a), sides[0]), times(dot(b, b), sides[1])), times(dot(c, c), sides[2]));
    const double circumradius = length(n) / (12 * volume);
    const double inradius = 3 * volume / area;
    return circumradius / (3 * inradius);
}

}  // namespace

TetShape shape_of(const Vector3 (&p)[4])
{
    // The two corners of each edge, and the two others.
    constexpr int kEdges[6][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}};
    TetShape shape;
    shape.least_angle = 180;
    for (const auto& e : kEdges) {
        const double angle = dihedral(p[e[0]], p[e[1]], p[e[2]], p[e[3]]);
        shape.least_angle = std::min(shape.least_angle, angle);
        shape.greatest_angle = std::max(shape.greatest_angle, angle);
    }
    const Vector3 a = minus(p[1], p[0]);
    const Vector3 b = minus(p[2], p[0]);
    const Vector3 c = minus(p[3], p[0]);
    shape.volume = dot(a, cross(b, c)) / 6;
    shape.radius_ratio =
        shape.volume == 0 ? std::numeric_limits<double>::infinity() : radius_ratio(a, b, c, std::abs(shape.volume));
    return shape;
}

}  // namespace cleft::io
