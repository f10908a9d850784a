// Measures single tetrahedra for their colour, with operations that give the same bits on every machine.
#include "io/render/tet_measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cleft::io
{

namespace
{

// Abramowitz and Stegun, Handbook of Mathematical Functions, 4.4.45: within 7e-5, which is 0.004 degrees and no step
// of a colour.
double arc_cosine_degrees(double cosine)
{
    const double x = std::min(1.0, std::abs(cosine));
    constexpr double kDegrees = 57.295779513082321;
    const double angle = kDegrees * std::sqrt(1 - x) * (1.5707288 + x * (-0.2121144 + x * (0.0742610 - x * 0.0187293)));
    return cosine < 0 ? 180 - angle : angle;
}

// Outward or inward normals of the faces, all alike; face i is opposite corner i.
std::array<Vector3, 4> normals_of(const std::array<Vector3, 4>& c)
{
    const Vector3 u = minus(c[1], c[0]), v = minus(c[2], c[0]), w = minus(c[3], c[0]);
    return {cross(minus(c[2], c[1]), minus(c[3], c[1])), cross(w, v), cross(u, w), cross(v, u)};
}

double least_angle(const std::array<Vector3, 4>& corners)
{
    const std::array<Vector3, 4> normals = normals_of(corners);
    double greatest_cosine = -1;
    for (size_t i = 0; i < 4; ++i)
        for (size_t j = i + 1; j < 4; ++j) {
            const double lengths = std::sqrt(dot(normals[i], normals[i])) * std::sqrt(dot(normals[j], normals[j]));
            greatest_cosine = std::max(greatest_cosine, lengths > 0 ? -dot(normals[i], normals[j]) / lengths : 1.0);
        }
    return arc_cosine_degrees(greatest_cosine);
}

double radius_ratio(const std::array<Vector3, 4>& c)
{
    const Vector3 u = minus(c[1], c[0]), v = minus(c[2], c[0]), w = minus(c[3], c[0]);
    const double six_volumes = std::abs(dot(u, cross(v, w)));
    if (!(six_volumes > 0))
        return std::numeric_limits<double>::infinity();
    double two_areas = 0;
    for (const Vector3& normal : normals_of(c))
        two_areas += std::sqrt(dot(normal, normal));
    Vector3 to_centre{};  // of the sphere through the corners, times two of the six volumes
    const Vector3 parts[] = {times(dot(u, u), cross(v, w)), times(dot(v, v), cross(w, u)),
                             times(dot(w, w), cross(u, v))};
    for (size_t axis = 0; axis < 3; ++axis)
        to_centre[axis] = parts[0][axis] + parts[1][axis] + parts[2][axis];
    // The radius inside is three volumes by the area.
    return std::sqrt(dot(to_centre, to_centre)) / (2 * six_volumes) / (3 * six_volumes / two_areas);
}

double mean_edge(const std::array<Vector3, 4>& corners)
{
    double sum = 0;
    for (size_t i = 0; i < 4; ++i)
        for (size_t j = i + 1; j < 4; ++j) {
            const Vector3 edge = minus(corners[j], corners[i]);
            sum += std::sqrt(dot(edge, edge));
        }
    return sum / 6;
}

}  // namespace

double tet_measure(cleft_io_colouring by, const std::array<Vector3, 4>& corners)
{
    switch (by) {
        case CLEFT_IO_BY_ANGLE:
            return least_angle(corners);
        case CLEFT_IO_BY_RATIO:
            return radius_ratio(corners);
        default:
            return mean_edge(corners);
    }
}

double same_log2(double value)
{
    int exponent = 0;
    const double part = std::frexp(value, &exponent);  // 0.5 to 1, exactly
    // The series of the area tangent, log m = 2 (s + s^3/3 + s^5/5 ...). |s| is at most 1/3 here, so the terms that are
    // left out are below 1e-7.
    const double s = (part - 1) / (part + 1);
    const double q = s * s;
    const double sum = s * (1 + q * (1.0 / 3 + q * (1.0 / 5 + q * (1.0 / 7 + q * (1.0 / 9 + q * (1.0 / 11))))));
    constexpr double kTwoByLog2 = 2.8853900817779268;
    return exponent + kTwoByLog2 * sum;
}

}  // namespace cleft::io
