#include "mesh/quality.hpp"

#include "base/parallel.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/angle_quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cleft
{

namespace
{

constexpr double kDegrees = 57.295779513082320877;
constexpr int64_t kGrain = 4096;

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

// The angle between two faces is atan2 of its sine and cosine, each times the lengths of both normals.
std::array<double, 6> dihedral_angles(const Corners& x, double six_volumes)
{
    const std::array<Vec3, 4> normals = face_normals(x);
    std::array<double, 6> angles;
    for (size_t e = 0; e < 6; ++e) {
        const Vec3& first = normals[static_cast<size_t>(kEdgeOpposite[e][0])];
        const Vec3& second = normals[static_cast<size_t>(kEdgeOpposite[e][1])];
        // 0 - x, not -x: between faces of no area -x would be -0, and the angle 180 degrees.
        const double cosine = 0 - first.dot(second);
        angles[e] = kDegrees * std::atan2(std::abs(six_volumes) * std::sqrt(squared_edge(x, e)), cosine);
    }
    return angles;
}

// The summary of a run of tetrahedra; mean_edge holds the sum of the edges until the end.
Quality empty_summary()
{
    const double infinity = std::numeric_limits<double>::infinity();
    Quality q;
    q.min_dihedral = q.min_edge = q.min_volume = infinity;
    return q;
}

void add_angles(const std::array<double, 6>& angles, Quality& q)
{
    const auto [least, greatest] = std::minmax_element(angles.begin(), angles.end());
    q.min_dihedral = std::min(q.min_dihedral, *least);
    q.max_dihedral = std::max(q.max_dihedral, *greatest);
    q.below_5 += *least < 5;
    q.below_10 += *least < 10;
    q.below_15 += *least < 15;
    q.below_20 += *least < 20;
    q.above_165 += *greatest > 165;
    for (const double angle : angles)
        if (angle >= 0)  // not so for a NaN
            ++q.dihedral_histogram[std::min<size_t>(static_cast<size_t>(angle / 5), q.dihedral_histogram.size() - 1)];
}

void add_edges(const Corners& x, Quality& q)
{
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
    for (size_t e = 0; e < 6; ++e) {
        const double length = std::sqrt(squared_edge(x, e));
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
        q.mean_edge += length;
    }
    q.min_edge = std::min(q.min_edge, shortest);
    q.max_edge = std::max(q.max_edge, longest);
    q.edge_ratio_max = std::max(q.edge_ratio_max, longest / shortest);
}

void add_tet(const Corners& x, Quality& q)
{
    const double six_volumes = orient(x[0], x[1], x[2], x[3]);
    ++q.tets;
    q.min_volume = std::min(q.min_volume, six_volumes / 6);
    q.total_volume += six_volumes / 6;
    add_angles(dihedral_angles(x, six_volumes), q);
    add_edges(x, q);
}

void combine(const Quality& part, Quality& whole)
{
    whole.tets += part.tets;
    whole.min_dihedral = std::min(whole.min_dihedral, part.min_dihedral);
    whole.max_dihedral = std::max(whole.max_dihedral, part.max_dihedral);
    whole.below_5 += part.below_5;
    whole.below_10 += part.below_10;
    whole.below_15 += part.below_15;
    whole.below_20 += part.below_20;
    whole.above_165 += part.above_165;
    whole.edge_ratio_max = std::max(whole.edge_ratio_max, part.edge_ratio_max);
    whole.min_edge = std::min(whole.min_edge, part.min_edge);
    whole.mean_edge += part.mean_edge;
    whole.max_edge = std::max(whole.max_edge, part.max_edge);
    whole.min_volume = std::min(whole.min_volume, part.min_volume);
    whole.total_volume += part.total_volume;
    for (size_t bin = 0; bin < whole.dihedral_histogram.size(); ++bin)
        whole.dihedral_histogram[bin] += part.dihedral_histogram[bin];
}

// Between the two nearest ranks; reorders the values, of which there is at least one.
double percentile(std::vector<double>& values, double share)
{
    const double rank = share * static_cast<double>(values.size() - 1);
    const auto below = values.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), below, values.end());
    if (below + 1 == values.end())
        return *below;
    const double above = *std::min_element(below + 1, values.end());
    return *below + (rank - std::floor(rank)) * (above - *below);
}

void add_radius_ratios(std::vector<double> ratios, Quality& q)
{
    ratios.erase(std::remove_if(ratios.begin(), ratios.end(), [](double r) { return !std::isfinite(r); }),
                 ratios.end());
    if (ratios.empty())
        return;
    q.radius_ratio_max = *std::max_element(ratios.begin(), ratios.end());
    q.radius_ratio_95 = percentile(ratios, 0.95);
    q.radius_ratio_median = percentile(ratios, 0.5);
}

}  // namespace

// By the formula of angle_quality.hpp.
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

double angle_quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const auto triple = [](const Vec3& x) { return Triple{x.x(), x.y(), x.z()}; };
    return angle_quality(triple(a), triple(b), triple(c), triple(d));
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

Quality measure_quality(const std::vector<Vec3>& points, const std::vector<Tet>& tets, const Run& run)
{
    if (tets.empty())
        return {};
    run.report(0, "measuring quality");
    const auto count = static_cast<int64_t>(tets.size());
    std::vector<Quality> parts(static_cast<size_t>(chunk_count(count, kGrain)), empty_summary());
    std::vector<double> ratios(tets.size());
    parallel_chunks(run, count, kGrain, [&](int64_t chunk, int64_t begin, int64_t end) {
        for (auto t = static_cast<size_t>(begin); t < static_cast<size_t>(end); ++t) {
            Corners x;
            for (size_t i = 0; i < 4; ++i)
                x[i] = points[static_cast<size_t>(tets[t][i])];
            add_tet(x, parts[static_cast<size_t>(chunk)]);
            ratios[t] = radius_ratio(x[0], x[1], x[2], x[3]);
        }
    });
    run.report(0.8, "measuring quality");
    Quality whole = empty_summary();
    for (const Quality& part : parts)
        combine(part, whole);
    whole.mean_edge /= 6 * static_cast<double>(count);
    add_radius_ratios(std::move(ratios), whole);
    return whole;
}

}  // namespace cleft
