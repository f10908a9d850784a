// Measures tetrahedra, each alone (angles, radius ratio) and all of a mesh (Quality).
#include "mesh/quality.hpp"

#include "base/degrees.hpp"
#include "base/percentile.hpp"
#include "base/stage.hpp"
#include "mesh/four_points.hpp"
#include "mesh/quality_sums.hpp"
#include "mesh/shape_quality.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

// The angle between two faces is atan2 of its sine and cosine, each times the lengths of both normals.
// An arc cosine would lose half of the digits near 0 and 180 degrees, where angles matter most.
FixedArray<double, 6> angles_at_edges(const FourPoints& x, double six_volumes)
{
    const FixedArray<Vec3, 4> normals = face_normals(x);
    FixedArray<double, 6> angles;
    for (size_t e = 0; e < 6; ++e) {
        const Vec3& first = normals[kEdgeOpposite[e][0]];
        const Vec3& second = normals[kEdgeOpposite[e][1]];
        // 0 - x, not -x: between faces of no area -x would be -0, and the angle 180 degrees.
        const double cosine = 0 - first.dot(second);
        angles[e] = kDegreesInRadian * std::atan2(std::abs(six_volumes) * std::sqrt(squared_edge(x, e)), cosine);
    }
    return angles;
}

Triple triple(const Vec3& x) { return {x.x(), x.y(), x.z()}; }

}  // namespace

// By the formula of shape_quality.hpp.
double least_sine(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const Vec3 ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b, cd = d - c;
    const Vec3 nd = ac.cross(ab);
    const double na2 = bc.cross(bd).squaredNorm(), nb2 = ad.cross(ac).squaredNorm();
    const double nc2 = ab.cross(ad).squaredNorm(), nd2 = nd.squaredNorm();
    const double na2_nb2 = na2 * nb2, nc2_nd2 = nc2 * nd2;
    const double product = na2_nb2 * nc2_nd2;
    const double square =
        std::min({ab.squaredNorm() * na2_nb2, ac.squaredNorm() * (na2 * nc2), ad.squaredNorm() * (na2 * nd2),
                  bc.squaredNorm() * (nb2 * nc2), bd.squaredNorm() * (nb2 * nd2), cd.squaredNorm() * nc2_nd2});
    return product > 0 ? -nd.dot(ad) * std::sqrt(square / product) : 0;
}

double greatest_angle(double least_angle)
{
    const double sine = sine_of(least_angle) / kObtuseWeight;
    return sine < 1 ? 180 - kDegreesInRadian * std::asin(sine) : 90;
}

double greatest_ratio(double least_angle) { return kRatioWeight / sine_of(least_angle); }

double angle_quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    return angle_quality(triple(a), triple(b), triple(c), triple(d));
}

double shape_quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    return shape_quality(triple(a), triple(b), triple(c), triple(d));
}

FixedArray<double, 6> dihedral_angles(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    return angles_at_edges({a, b, c, d}, orient(a, b, c, d));
}

double radius_ratio(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const FourPoints x{a, b, c, d};
    return radius_ratio(x, face_normals(x), orient(a, b, c, d));
}

Quality measure_quality(const Array<Vec3>& points, const Array<Tet>& tets, const Run& run)
{
    Steps steps(run, {{"measuring quality", 8}, {nullptr, 2}});
    MeasuredTets measured = measure_tets(points, tets, tets.count(), steps.next());
    steps.next();
    Array<double> percentiles;
    for (const double share : kRatioShares)
        percentiles.push_back(measured.ratios.empty() ? 0 : percentile(measured.ratios, share));
    return finished(measured.sums, percentiles);
}

}  // namespace cleft
