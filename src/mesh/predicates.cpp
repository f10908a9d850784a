// The exact orientation of four points: a determinant with a bound on its error, and whole numbers where that fails.
#include "mesh/predicates.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cfloat>
#include <climits>
#include <cmath>

namespace cleft
{

namespace
{

using boost::multiprecision::cpp_int;

// Between these bounds no product of three differences overflows, and what underflow can do to the determinant is
// far below kUnderflow.
constexpr double kGreatest = 1e90;
constexpr double kUnderflow = 1e-220;
// The rounding error of the determinant below is less than this times the sum of the magnitudes of its terms
// (Shewchuk 1997, bound A of orient3d).
constexpr double kRounding = (7 + 56 * (DBL_EPSILON / 2)) * (DBL_EPSILON / 2);

int sign(double x) { return (x > 0) - (x < 0); }

// x / 2^exponent, which must be a whole number.
// Where coordinates differ in size as much as doubles can, numbers have some 2,100 bits. That is slow, but no sign is
// ever wrong.
cpp_int scaled(double x, int exponent)
{
    int e = 0;
    const double mantissa = std::frexp(x, &e);
    cpp_int whole = static_cast<long long>(std::ldexp(mantissa, DBL_MANT_DIG));
    const int shift = e - DBL_MANT_DIG - exponent;
    if (shift >= 0)
        whole <<= shift;
    else
        whole >>= -shift;  // drops zero bits only
    return whole;
}

// An exponent such that all coordinates are multiples of its power of two.
int common_exponent(const std::array<const Vec3*, 4>& points)
{
    int least = INT_MAX;
    for (const Vec3* point : points)
        for (const double x : *point) {
            int e = 0;
            if (std::frexp(x, &e) != 0)
                least = std::min(least, e - DBL_MANT_DIG);
        }
    return least == INT_MAX ? 0 : least;
}

// Whole-number arithmetic: a common power of two does not change the sign.
int exact_orient_sign(const std::array<const Vec3*, 4>& points)
{
    const int exponent = common_exponent(points);
    std::array<std::array<cpp_int, 3>, 3> edge;
    for (size_t axis = 0; axis < 3; ++axis) {
        const auto coordinate = [&](size_t i) { return scaled((*points[i])[static_cast<int>(axis)], exponent); };
        const cpp_int origin = coordinate(0);
        for (size_t i = 0; i < 3; ++i)
            edge[i][axis] = coordinate(i + 1) - origin;
    }
    const auto& [u, v, w] = edge;
    const cpp_int det =
        (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] + (u[0] * v[1] - u[1] * v[0]) * w[2];
    return det.sign();
}

}  // namespace

int orient_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const Vec3 u = b - a, v = c - a, w = d - a;
    const double yz = u[1] * v[2], zy = u[2] * v[1];
    const double zx = u[2] * v[0], xz = u[0] * v[2];
    const double xy = u[0] * v[1], yx = u[1] * v[0];
    const double det = (yz - zy) * w[0] + (zx - xz) * w[1] + (xy - yx) * w[2];
    const double magnitude = (std::abs(yz) + std::abs(zy)) * std::abs(w[0]) +
                             (std::abs(zx) + std::abs(xz)) * std::abs(w[1]) +
                             (std::abs(xy) + std::abs(yx)) * std::abs(w[2]);
    const double greatest = std::max({u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff(), w.cwiseAbs().maxCoeff()});
    // Nearly all tetrahedra of a mesh are decided here, so the exact arithmetic may be slow.
    if (greatest < kGreatest && std::abs(det) > kRounding * magnitude + kUnderflow)
        return sign(det);
    return exact_orient_sign({&a, &b, &c, &d});
}

}  // namespace cleft
