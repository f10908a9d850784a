// Exact predicates: a determinant with a bound on its error, and whole numbers where that fails.
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
// The same for spheres, whose terms are of the fifth degree (bound A of insphere).
constexpr double kGreatestOfSphere = 1e54;
constexpr double kSphereRounding = (16 + 224 * (DBL_EPSILON / 2)) * (DBL_EPSILON / 2);

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
template <size_t N>
int common_exponent(const std::array<const Vec3*, N>& points)
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

using WholeVector = std::array<cpp_int, 3>;

// From the first point to the others, in whole numbers: a common power of two does not change a sign.
template <size_t N>
std::array<WholeVector, N - 1> whole_edges(const std::array<const Vec3*, N>& points)
{
    const int exponent = common_exponent(points);
    std::array<WholeVector, N - 1> edge;
    for (size_t axis = 0; axis < 3; ++axis) {
        const auto coordinate = [&](size_t i) { return scaled((*points[i])[static_cast<int>(axis)], exponent); };
        const cpp_int origin = coordinate(0);
        for (size_t i = 0; i + 1 < N; ++i)
            edge[i][axis] = coordinate(i + 1) - origin;
    }
    return edge;
}

cpp_int determinant(const WholeVector& u, const WholeVector& v, const WholeVector& w)
{
    return (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] + (u[0] * v[1] - u[1] * v[0]) * w[2];
}

cpp_int square(const WholeVector& u) { return u[0] * u[0] + u[1] * u[1] + u[2] * u[2]; }

int exact_orient_sign(const std::array<const Vec3*, 4>& points)
{
    const auto [u, v, w] = whole_edges(points);
    return determinant(u, v, w).sign();
}

// `points`: e, a, b, c, d.
int exact_in_sphere_sign(const std::array<const Vec3*, 5>& points)
{
    const auto [a, b, c, d] = whole_edges(points);
    const cpp_int det = square(b) * determinant(a, c, d) - square(a) * determinant(b, c, d) +
                        square(d) * determinant(a, b, c) - square(c) * determinant(a, b, d);
    return -det.sign();
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

int in_sphere_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e)
{
    const Vec3 p = a - e, q = b - e, r = c - e, s = d - e;
    // Minors of the x and y of two points, each with the sum of the magnitudes of its two products.
    struct Minor {
        double value, magnitude;
        Minor(const Vec3& u, const Vec3& v)
            : value(u[0] * v[1] - v[0] * u[1]), magnitude(std::abs(u[0] * v[1]) + std::abs(v[0] * u[1]))
        {
        }
    };
    const Minor pq(p, q), qr(q, r), rs(r, s), sp(s, p), pr(p, r), qs(q, s);
    const double pqr = p[2] * qr.value - q[2] * pr.value + r[2] * pq.value;
    const double qrs = q[2] * rs.value - r[2] * qs.value + s[2] * qr.value;
    const double rsp = r[2] * sp.value + s[2] * pr.value + p[2] * rs.value;
    const double spq = s[2] * pq.value + p[2] * qs.value + q[2] * sp.value;
    const double pp = p.squaredNorm(), qq = q.squaredNorm(), rr = r.squaredNorm(), ss = s.squaredNorm();
    const double det = (ss * pqr - rr * spq) + (qq * rsp - pp * qrs);
    const double pz = std::abs(p[2]), qz = std::abs(q[2]), rz = std::abs(r[2]), sz = std::abs(s[2]);
    const double magnitude = (rs.magnitude * qz + qs.magnitude * rz + qr.magnitude * sz) * pp +
                             (sp.magnitude * rz + pr.magnitude * sz + rs.magnitude * pz) * qq +
                             (pq.magnitude * sz + qs.magnitude * pz + sp.magnitude * qz) * rr +
                             (qr.magnitude * pz + pr.magnitude * qz + pq.magnitude * rz) * ss;
    const double greatest =
        std::max({p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff(), r.cwiseAbs().maxCoeff(), s.cwiseAbs().maxCoeff()});
    if (greatest < kGreatestOfSphere && std::abs(det) > kSphereRounding * magnitude + kUnderflow)
        return -sign(det);
    return exact_in_sphere_sign({&e, &a, &b, &c, &d});
}

}  // namespace cleft
