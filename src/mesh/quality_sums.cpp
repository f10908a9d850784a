// Measures chunks of tetrahedra on all threads, and combines what they give in their order.
#include "mesh/quality_sums.hpp"

#include "base/degrees.hpp"
#include "base/parallel.hpp"
#include "mesh/four_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cleft
{

namespace
{

// Tetrahedra per chunk. Sums are taken chunk by chunk, so another number would change them in the last digits.
constexpr int64_t kTetsMeasured = 4096;

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

// The extreme angles are kept as the tetrahedra that have them.
// So only two tetrahedra of a whole mesh need exact angles, by the slower formula.
struct Chunk {
    QualitySums sums;
    int64_t sharpest = 0, bluntest = 0;
};

void add_cosines(const FixedArray<double, 6>& cosines, int64_t tet, const AngleBins& bins, Chunk& chunk)
{
    double greatest = -2, least = 2;
    for (const double c : cosines) {
        // Points that are not finite can come from a user's mesh; such an angle is in no bin.
        if (std::isnan(c))
            continue;
        greatest = std::max(greatest, c);
        least = std::min(least, c);
        ++chunk.sums.q.dihedral_histogram[bins.bin(c)];
    }
    if (greatest < least)
        return;
    const size_t sharpest = bins.bin(greatest);
    chunk.sums.q.below_5 += sharpest < 1;
    chunk.sums.q.below_10 += sharpest < 2;
    chunk.sums.q.below_15 += sharpest < 3;
    chunk.sums.q.below_20 += sharpest < 4;
    chunk.sums.q.above_165 += bins.bin(least) >= 33;
    if (greatest > chunk.sums.greatest_cosine) {
        chunk.sums.greatest_cosine = greatest;
        chunk.sharpest = tet;
    }
    if (least < chunk.sums.least_cosine) {
        chunk.sums.least_cosine = least;
        chunk.bluntest = tet;
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

// Returns the radius ratio.
double add_tet(const FourPoints& x, int64_t tet, const AngleBins& bins, Chunk& chunk)
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
    ++chunk.sums.q.tets;
    chunk.sums.q.min_volume = std::min(chunk.sums.q.min_volume, six_volumes / 6);
    chunk.sums.q.total_volume += six_volumes / 6;
    add_cosines(cosines, tet, bins, chunk);
    add_edges(lengths, chunk.sums.q);
    return radius_ratio(x, normals, six_volumes);
}

void add_counts(const Quality& from, Quality& to)
{
    to.tets += from.tets;
    to.below_5 += from.below_5;
    to.below_10 += from.below_10;
    to.below_15 += from.below_15;
    to.below_20 += from.below_20;
    to.above_165 += from.above_165;
    for (size_t bin = 0; bin < to.dihedral_histogram.size(); ++bin)
        to.dihedral_histogram[bin] += from.dihedral_histogram[bin];
}

// The least and the greatest.
FixedArray<double, 2> extreme_angles(const FourPoints& x)
{
    const FixedArray<double, 6> angles = dihedral_angles(x[0], x[1], x[2], x[3]);
    const auto [least, greatest] = std::minmax_element(angles.begin(), angles.end());
    return {*least, *greatest};
}

Chunk combined(const Array<Chunk>& chunks)
{
    Chunk all;
    for (const Chunk& chunk : chunks) {
        if (chunk.sums.greatest_cosine > all.sums.greatest_cosine)
            all.sharpest = chunk.sharpest;
        if (chunk.sums.least_cosine < all.sums.least_cosine)
            all.bluntest = chunk.bluntest;
        combine(chunk.sums, all.sums);
    }
    return all;
}

}  // namespace

QualitySums::QualitySums() { q.min_edge = q.min_volume = std::numeric_limits<double>::infinity(); }

MeasuredTets measure_tets(const Array<Vec3>& points, const Array<Tet>& tets, int64_t count, const Run& run)
{
    const auto corners = [&](int64_t t) {
        FourPoints x;
        for (size_t i = 0; i < 4; ++i)
            x[i] = points[tets[t][i]];
        return x;
    };
    if (count == 0)
        return {};
    const AngleBins bins;
    Array<Chunk> chunks(chunk_count(count, kTetsMeasured));
    Array<double> ratios(count);
    parallel_chunks(run, count, kTetsMeasured, [&](int64_t chunk, int64_t begin, int64_t end) {
        for (int64_t t = begin; t < end; ++t)
            ratios[t] = add_tet(corners(t), t, bins, chunks[chunk]);
    });
    Chunk all = combined(chunks);
    Quality& q = all.sums.q;
    q.min_dihedral = extreme_angles(corners(all.sharpest))[0];
    q.max_dihedral = extreme_angles(corners(all.bluntest))[1];
    ratios.erase(std::remove_if(ratios.begin(), ratios.end(), [](double r) { return !std::isfinite(r); }),
                 ratios.end());
    if (!ratios.empty())
        q.radius_ratio_max = *std::max_element(ratios.begin(), ratios.end());
    return {all.sums, std::move(ratios)};
}

void combine(const QualitySums& from, QualitySums& to)
{
    if (from.greatest_cosine > to.greatest_cosine) {
        to.greatest_cosine = from.greatest_cosine;
        to.q.min_dihedral = from.q.min_dihedral;
    }
    if (from.least_cosine < to.least_cosine) {
        to.least_cosine = from.least_cosine;
        to.q.max_dihedral = from.q.max_dihedral;
    }
    add_counts(from.q, to.q);
    to.q.radius_ratio_max = std::max(to.q.radius_ratio_max, from.q.radius_ratio_max);
    to.q.edge_ratio_max = std::max(to.q.edge_ratio_max, from.q.edge_ratio_max);
    to.q.min_edge = std::min(to.q.min_edge, from.q.min_edge);
    to.q.mean_edge += from.q.mean_edge;
    to.q.max_edge = std::max(to.q.max_edge, from.q.max_edge);
    to.q.min_volume = std::min(to.q.min_volume, from.q.min_volume);
    to.q.total_volume += from.q.total_volume;
}

Quality finished(const QualitySums& sums, const Array<double>& ratio_percentiles)
{
    if (sums.q.tets == 0)
        return {};
    Quality q = sums.q;
    q.mean_edge /= 6 * static_cast<double>(q.tets);
    q.radius_ratio_median = ratio_percentiles[0];
    q.radius_ratio_95 = ratio_percentiles[1];
    return q;
}

}  // namespace cleft
