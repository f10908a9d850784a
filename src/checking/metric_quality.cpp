// Measures edges once each, and tetrahedra once each. What is summed are whole numbers, so the threads do not matter.
#include "checking/metric_quality.hpp"

#include "base/parallel.hpp"
#include "base/percentile.hpp"
#include "base/stage.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/point_stars.hpp"
#include "mesh/quality.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

// Points or tetrahedra that a thread takes. The number changes the time alone.
constexpr int64_t kMetricAtOnce = 4096;

// The metric at each point, and its logarithm.
struct PointMetrics {
    Array<Tensor> log, metric;
};

PointMetrics metrics_at(const Array<Vec3>& points, const MetricField& field, const Run& run)
{
    PointMetrics at{Array<Tensor>(points.size()), Array<Tensor>(points.size())};
    parallel_for(run, points.count(), kMetricAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t p = begin; p < end; ++p) {
            at.log[p] = field.log_at(points[p]);
            at.metric[p] = exp(at.log[p]);
        }
    });
    return at;
}

// The integral of the length along the edge, if it changes by the same factor over the same way: (a - b) / log(a / b)
// of its lengths by the metrics of its ends.
double edge_length(double a, double b)
{
    constexpr double kEqual = 1e-6;  // the mean differs from it by a square of this
    const double difference = a - b;
    return std::abs(difference) <= kEqual * b ? (a + b) / 2 : difference / std::log(a / b);
}

// The lengths of the edges from a point to points of higher numbers.
void add_edges_of(int32_t point, const TetMesh& mesh, const PointMetrics& at, const PointStars& stars,
                  Array<int32_t>& ends, Array<double>& lengths)
{
    ends.clear();
    for (const int32_t t : stars.at(point))
        for (const int32_t end : mesh.tets[t])
            if (end > point)
                ends.push_back(end);
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for (const int32_t end : ends) {
        const Vec3 edge = mesh.points[end] - mesh.points[point];
        lengths.push_back(
            edge_length(std::sqrt(square(at.metric[point], edge)), std::sqrt(square(at.metric[end], edge))));
    }
}

Array<double> edge_lengths(const TetMesh& mesh, const PointMetrics& at, const Run& run)
{
    const PointStars stars(mesh.tets, mesh.points.size(), run);
    Array<Array<double>> parts(chunk_count(mesh.points.count(), kMetricAtOnce));
    parallel_chunks(run, mesh.points.count(), kMetricAtOnce, [&](int64_t chunk, int64_t begin, int64_t end) {
        Array<int32_t> ends;
        for (int64_t p = begin; p < end; ++p)
            add_edges_of(static_cast<int32_t>(p), mesh, at, stars, ends, parts[chunk]);
    });
    Array<double> lengths;
    for (const Array<double>& part : parts)
        lengths.insert(lengths.end(), part.begin(), part.end());
    return lengths;
}

// By the metric of the corner where the wanted tetrahedra are smallest.
double mean_ratio(const Tet& tet, const std::array<Vec3, 4>& x, const PointMetrics& at)
{
    // Of the regular tetrahedron with edges of length 1.
    static const double volume_of_unit = 1 / (6 * std::sqrt(2.0));
    // The logarithm of a determinant is a trace.
    const int32_t corner = *std::max_element(
        tet.begin(), tet.end(), [&](int32_t a, int32_t b) { return at.log[a].trace() < at.log[b].trace(); });
    double squares = 0;
    for (const auto& edge : kEdgeCorners)
        squares += square(at.metric[corner], x[to_size(edge[1])] - x[to_size(edge[0])]);
    const double volume = orient(x[0], x[1], x[2], x[3]) / 6 * std::exp(at.log[corner].trace() / 2);
    return std::copysign(std::pow(std::abs(volume) / volume_of_unit, 2.0 / 3), volume) / (squares / 6);
}

struct AnglesPart {
    double least = 180, greatest = 0;
    FixedArray<int64_t, 36> histogram{};
};

void add_angles(const std::array<Vec3, 4>& x, AnglesPart& part)
{
    for (const double angle : dihedral_angles(x[0], x[1], x[2], x[3])) {
        // Points that are not finite can come from a user's mesh; such an angle is in no bin.
        if (std::isnan(angle))
            continue;
        part.least = std::min(part.least, angle);
        part.greatest = std::max(part.greatest, angle);
        ++part.histogram[std::min(static_cast<int>(angle / 5), 35)];
    }
}

void combine(const AnglesPart& from, AnglesPart& to)
{
    to.least = std::min(to.least, from.least);
    to.greatest = std::max(to.greatest, from.greatest);
    for (size_t bin = 0; bin < to.histogram.size(); ++bin)
        to.histogram[bin] += from.histogram[bin];
}

// The mean ratios are returned.
Array<double> measure_tets(const TetMesh& mesh, const PointMetrics& at, MetricQuality& q, const Run& run)
{
    Array<double> ratios(mesh.tets.size());
    Array<AnglesPart> parts(chunk_count(mesh.tets.count(), kMetricAtOnce));
    parallel_chunks(run, mesh.tets.count(), kMetricAtOnce, [&](int64_t chunk, int64_t begin, int64_t end) {
        for (int64_t t = begin; t < end; ++t) {
            std::array<Vec3, 4> x;
            Tensor logs;
            for (size_t i = 0; i < 4; ++i) {
                x[i] = mesh.points[mesh.tets[t][i]];
                logs = logs + at.log[mesh.tets[t][i]];
            }
            ratios[t] = mean_ratio(mesh.tets[t], x, at);
            add_angles(measured(x, logs), parts[chunk]);
        }
    });
    AnglesPart whole;
    for (const AnglesPart& part : parts)
        combine(part, whole);
    q.min_dihedral = whole.least;
    q.max_dihedral = whole.greatest;
    q.dihedral_histogram = whole.histogram;
    return ratios;
}

void drop_what_is_not_finite(Array<double>& values)
{
    values.erase(std::remove_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); }),
                 values.end());
}

void add_lengths(Array<double> lengths, MetricQuality& q)
{
    q.edges = lengths.count();
    q.edges_in_range = std::count_if(lengths.begin(), lengths.end(), [](double length) {
        return length >= std::sqrt(0.5) && length <= std::sqrt(2.0);
    });
    drop_what_is_not_finite(lengths);
    if (lengths.empty())
        return;
    q.edge_least = percentile(lengths, 0);
    q.edge_01 = percentile(lengths, 0.01);
    q.edge_median = percentile(lengths, 0.5);
    q.edge_99 = percentile(lengths, 0.99);
    q.edge_greatest = percentile(lengths, 1);
}

void add_ratios(Array<double> ratios, MetricQuality& q)
{
    drop_what_is_not_finite(ratios);
    if (ratios.empty())
        return;
    q.mean_ratio_least = percentile(ratios, 0);
    q.mean_ratio_01 = percentile(ratios, 0.01);
    q.mean_ratio_median = percentile(ratios, 0.5);
}

}  // namespace

MetricQuality measure_by_metric(const TetMesh& mesh, const MetricField& metric, const Run& run)
{
    MetricQuality q;
    if (mesh.tets.empty())
        return q;
    Steps steps(run, {{"measuring by the metric", 1}, {nullptr, 2}, {nullptr, 4}});
    const PointMetrics at = metrics_at(mesh.points, metric, steps.next());
    add_lengths(edge_lengths(mesh, at, steps.next()), q);
    add_ratios(measure_tets(mesh, at, q, steps.next()), q);
    return q;
}

}  // namespace cleft
