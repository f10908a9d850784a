// Measures tetrahedra, each alone (angles, radius ratio) and all of a mesh in one pass (Quality).
#include "mesh/quality.hpp"

#include "base/degrees.hpp"
#include "base/parallel.hpp"
#include "base/percentile.hpp"
#include "base/stage.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/shape_quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cleft
{

namespace
{

// Tetrahedra per chunk. Sums are taken chunk by chunk, so another number would change them in the last digits.
constexpr int64_t kTetsMeasured = 4096;

using FourPoints = FixedArray<Vec3, 4>;

// Outward normals of the faces of a positive tetrahedron, twice their areas long; face i is opposite corner i.
FixedArray<Vec3, 4> face_normals(const FourPoints& x)
{
    FixedArray<Vec3, 4> normals;
    for (size_t i = 0; i < 4; ++i) {
        const int* f = kFaceCorners[i];
        const Vec3& a = x[f[0]];
        normals[i] = (x[f[1]] - a).cross(x[f[2]] - a);
    }
    return normals;
}

double squared_edge(const FourPoints& x, size_t e)
{
    return (x[kEdgeCorners[e][1]] - x[kEdgeCorners[e][0]]).squaredNorm();
}

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

// The bin of the histogram that an angle is in, from its cosine: a look into a table, where the angle itself takes an
// inverse function. Cells of the cosine are narrower than the narrowest bin, so one cell lies in one bin or in two.
class AngleBins
{
public:
    AngleBins()
    {
        for (size_t b = 0; b < cosine_.size(); ++b)
            cosine_[b] = std::cos(static_cast<double>(5 * b) / kDegreesInRadian);
        for (size_t c = 0, b = 0; c < first_.size(); ++c) {
            while (b + 2 < cosine_.size() && 1 - static_cast<double>(c) / kCells <= cosine_[b + 1])
                ++b;
            first_[c] = static_cast<uint8_t>(b);
        }
    }

    size_t bin(double cosine) const
    {
        const double inside = std::min(1.0, std::max(-1.0, cosine));
        const size_t first = first_[static_cast<int>((1 - inside) * kCells)];
        return first + (first + 2 < cosine_.size() && inside <= cosine_[first + 1]);
    }

private:
    // A cell is 0.002 wide and the narrowest bin, 0 to 5 degrees, 0.0038. Fewer cells would put two borders into one.
    static constexpr double kCells = 512;  // a unit of the cosine
    FixedArray<double, 37> cosine_;        // where each bin begins
    FixedArray<uint8_t, 1025> first_;
};

// The summary of a run of tetrahedra; mean_edge holds the sum of the edges until the end. The extreme angles are kept
// as the tetrahedra that have them.
// So only two tetrahedra of a whole mesh need exact angles, by the slower formula.
struct QualityPart {
    Quality q;
    double greatest_cosine = -2, least_cosine = 2;
    int64_t sharpest = 0, bluntest = 0;
};

QualityPart empty_part()
{
    QualityPart part;
    part.q.min_edge = part.q.min_volume = std::numeric_limits<double>::infinity();
    return part;
}

void add_cosines(const FixedArray<double, 6>& cosines, int64_t tet, const AngleBins& bins, QualityPart& part)
{
    double greatest = -2, least = 2;
    for (const double c : cosines) {
        // Points that are not finite can come from a user's mesh; such an angle is in no bin.
        if (std::isnan(c))
            continue;
        greatest = std::max(greatest, c);
        least = std::min(least, c);
        ++part.q.dihedral_histogram[bins.bin(c)];
    }
    if (greatest < least)
        return;
    const size_t sharpest = bins.bin(greatest);
    part.q.below_5 += sharpest < 1;
    part.q.below_10 += sharpest < 2;
    part.q.below_15 += sharpest < 3;
    part.q.below_20 += sharpest < 4;
    part.q.above_165 += bins.bin(least) >= 33;
    if (greatest > part.greatest_cosine) {
        part.greatest_cosine = greatest;
        part.sharpest = tet;
    }
    if (least < part.least_cosine) {
        part.least_cosine = least;
        part.bluntest = tet;
    }
}

void add_edges(const FixedArray<double, 6>& lengths, Quality& q)
{
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
    for (const double length : lengths) {
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
        q.mean_edge += length;
    }
    q.min_edge = std::min(q.min_edge, shortest);
    q.max_edge = std::max(q.max_edge, longest);
    q.edge_ratio_max = std::max(q.edge_ratio_max, longest / shortest);
}

// Circumradius |p| / (2 |6V|), inradius |6V| / (2 sum of areas).
double radius_ratio(const FourPoints& x, const FixedArray<Vec3, 4>& normals, double six_volumes)
{
    Vec3 p = Vec3::Zero();
    double areas = 0;  // twice
    for (size_t i = 0; i < 4; ++i) {
        p += (x[i] - x[0]).squaredNorm() * normals[i];
        areas += normals[i].norm();
    }
    return p.norm() * areas / (6 * six_volumes * six_volumes);
}

// Returns the radius ratio.
double add_tet(const FourPoints& x, int64_t tet, const AngleBins& bins, QualityPart& part)
{
    const FixedArray<Vec3, 4> normals = face_normals(x);
    const double six_volumes = -normals[3].dot(x[3] - x[0]);
    FixedArray<double, 4> areas;  // twice
    for (size_t i = 0; i < 4; ++i)
        areas[i] = normals[i].norm();
    FixedArray<double, 6> cosines, lengths;
    for (size_t e = 0; e < 6; ++e) {
        const int f = kEdgeOpposite[e][0], g = kEdgeOpposite[e][1];
        const double product = areas[f] * areas[g];
        cosines[e] = product == 0 ? 1 : -normals[f].dot(normals[g]) / product;  // 0 degrees at faces of no area
        lengths[e] = std::sqrt(squared_edge(x, e));
    }
    ++part.q.tets;
    part.q.min_volume = std::min(part.q.min_volume, six_volumes / 6);
    part.q.total_volume += six_volumes / 6;
    add_cosines(cosines, tet, bins, part);
    add_edges(lengths, part.q);
    return radius_ratio(x, normals, six_volumes);
}

void combine(const QualityPart& part, QualityPart& whole)
{
    const Quality& from = part.q;
    Quality& to = whole.q;
    to.tets += from.tets;
    to.below_5 += from.below_5;
    to.below_10 += from.below_10;
    to.below_15 += from.below_15;
    to.below_20 += from.below_20;
    to.above_165 += from.above_165;
    to.edge_ratio_max = std::max(to.edge_ratio_max, from.edge_ratio_max);
    to.min_edge = std::min(to.min_edge, from.min_edge);
    to.mean_edge += from.mean_edge;
    to.max_edge = std::max(to.max_edge, from.max_edge);
    to.min_volume = std::min(to.min_volume, from.min_volume);
    to.total_volume += from.total_volume;
    for (size_t bin = 0; bin < to.dihedral_histogram.size(); ++bin)
        to.dihedral_histogram[bin] += from.dihedral_histogram[bin];
    if (part.greatest_cosine > whole.greatest_cosine) {
        whole.greatest_cosine = part.greatest_cosine;
        whole.sharpest = part.sharpest;
    }
    if (part.least_cosine < whole.least_cosine) {
        whole.least_cosine = part.least_cosine;
        whole.bluntest = part.bluntest;
    }
}

// The least and the greatest.
FixedArray<double, 2> extreme_angles(const FourPoints& x)
{
    const FixedArray<double, 6> angles = angles_at_edges(x, orient(x[0], x[1], x[2], x[3]));
    const auto [least, greatest] = std::minmax_element(angles.begin(), angles.end());
    return {*least, *greatest};
}

void add_radius_ratios(Array<double> ratios, Quality& q)
{
    ratios.erase(std::remove_if(ratios.begin(), ratios.end(), [](double r) { return !std::isfinite(r); }),
                 ratios.end());
    if (ratios.empty())
        return;
    q.radius_ratio_max = *std::max_element(ratios.begin(), ratios.end());
    q.radius_ratio_95 = percentile(ratios, 0.95);
    q.radius_ratio_median = percentile(ratios, 0.5);
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
    if (tets.empty())
        return {};
    Steps steps(run, {{"measuring quality", 8}, {nullptr, 2}});
    const auto corners = [&](int64_t t) {
        FourPoints x;
        for (size_t i = 0; i < 4; ++i)
            x[i] = points[tets[t][i]];
        return x;
    };
    const auto count = tets.count();
    const AngleBins bins;
    Array<QualityPart> parts(chunk_count(count, kTetsMeasured), empty_part());
    Array<double> ratios(tets.size());
    parallel_chunks(steps.next(), count, kTetsMeasured, [&](int64_t chunk, int64_t begin, int64_t end) {
        for (int64_t t = begin; t < end; ++t)
            ratios[t] = add_tet(corners(t), t, bins, parts[chunk]);
    });
    steps.next();
    QualityPart whole = empty_part();
    for (const QualityPart& part : parts)
        combine(part, whole);
    Quality& q = whole.q;
    q.mean_edge /= 6 * static_cast<double>(count);
    q.min_dihedral = extreme_angles(corners(whole.sharpest))[0];
    q.max_dihedral = extreme_angles(corners(whole.bluntest))[1];
    add_radius_ratios(std::move(ratios), q);
    return q;
}

}  // namespace cleft
