// Metrics of callers, and the changes of metrics that keep their directions.
#include "sizing/metric_sizing.hpp"

#include "base/number_text.hpp"
#include "base/ordinal.hpp"
#include "base/parallel.hpp"
#include "volume/limits.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <string>

namespace cleft
{

namespace
{

// Voxels that a thread takes. The number changes the time alone.
constexpr int64_t kTensorsAtOnce = 1 << 12;

using Six = std::array<float, 6>;

Tensor to_tensor(const Six& l) { return {l[0], l[1], l[2], l[3], l[4], l[5]}; }

Six to_six(const Tensor& l)
{
    return {static_cast<float>(l.xx), static_cast<float>(l.xy), static_cast<float>(l.xz),
            static_cast<float>(l.yy), static_cast<float>(l.yz), static_cast<float>(l.zz)};
}

// The size of a tetrahedron that is as large, of one whose metric has this logarithm.
float mean_size(const Tensor& log) { return static_cast<float>(std::exp(-log.trace() / 6)); }

double size_of(double log_eigenvalue) { return std::exp(-0.5 * log_eigenvalue); }

// The logarithm of the local metric of a world metric that is finite. Throws if it cannot be one; `of_what` begins the
// sentence.
Tensor checked_log(const Tensor& metric, const Placement& placement, const std::string& of_what)
{
    const Mat3 local = placement.linear.transpose() * metric.matrix() * placement.linear;
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(local);
    const Vec3 values = solver.eigenvalues();
    // What is left of an eigenvalue of 0 is rounding error.
    if (!(values[0] > 1e-14 * values[2]))
        throw Error(CLEFT_ERROR_ARGUMENT, of_what + " is not positive definite: its least eigenvalue is " +
                                              number_text(values[0]) + " and its greatest " + number_text(values[2]));
    const double greatest = 1 / std::sqrt(values[0]), least = 1 / std::sqrt(values[2]);
    if (!is_size(least) || !is_size(greatest))
        throw Error(CLEFT_ERROR_ARGUMENT, of_what + " asks for sizes from " + number_text(least) + " to " +
                                              number_text(greatest) + "; they must be within " +
                                              number_text(kLeastSize) + " to " + number_text(kGreatestSize));
    if (greatest > kGreatestSizeRatio * least)
        throw Error(CLEFT_ERROR_ARGUMENT, of_what + " asks for sizes from " + number_text(least) + " to " +
                                              number_text(greatest) + ": one may be at most " +
                                              number_text(kGreatestSizeRatio) + " times the other");
    const Vec3 logs = values.array().log();
    return cleft::to_tensor(Mat3(solver.eigenvectors() * logs.asDiagonal() * solver.eigenvectors().transpose()));
}

// Changes the logarithms of the eigenvalues at each voxel where is_wanted(their range) holds, and the mean size.
template <class Change>
void change_eigenvalues(SizingField& field, const Run& run, const Change& change)
{
    MetricField metric = *field.metric;
    parallel_for(run, field.h.count(), kTensorsAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t v = begin; v < end; ++v) {
            const Tensor log = to_tensor(metric.log[v]);
            const Vec3 before = eigenvalues(log);
            if (before == change(before, v))
                continue;
            const Eigen::SelfAdjointEigenSolver<Mat3> solver(log.matrix());
            const Vec3 logs = change(solver.eigenvalues(), v);
            const Mat3& axes = solver.eigenvectors();
            metric.log[v] = to_six(cleft::to_tensor(Mat3(axes * logs.asDiagonal() * axes.transpose())));
            field.h[v] = mean_size(to_tensor(metric.log[v]));
        }
    });
    field.metric = std::make_shared<const MetricField>(std::move(metric));
}

void intersect_metrics(SizingField& field, const MetricField& other, const Run& run)
{
    MetricField metric = *field.metric;
    parallel_for(run, field.h.count(), kTensorsAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t v = begin; v < end; ++v) {
            const Tensor both = intersection(exp(to_tensor(metric.log[v])), exp(to_tensor(other.log[v])));
            metric.log[v] = to_six(log(both));
            field.h[v] = mean_size(to_tensor(metric.log[v]));
        }
    });
    field.metric = std::make_shared<const MetricField>(std::move(metric));
}

}  // namespace

template <class Value>
SizingField sizing_from_metric(const Grid& grid, const Placement& placement, const Value* values, const Run& run)
{
    SizingField field{grid, Array<float>(grid.size())};
    MetricField logs{grid, Array<Six>(grid.size())};
    // The error of the lowest chunk is the one that is thrown, so the voxel that it names is the first.
    parallel_for(run, grid.size(), kTensorsAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t v = begin; v < end; ++v) {
            const Value* m = values + 6 * v;
            const Tensor metric{double{m[0]}, double{m[1]}, double{m[2]}, double{m[3]}, double{m[4]}, double{m[5]}};
            if (!std::all_of(m, m + 6, [](Value x) { return std::isfinite(x); }))
                throw Error(CLEFT_ERROR_NOT_FINITE,
                            "the metric of " + voxel_in_words(v, grid.dims) + " has a NaN or infinite number");
            const Tensor log = checked_log(metric, placement, "the metric of " + voxel_in_words(v, grid.dims));
            logs.log[v] = to_six(log);
            field.h[v] = mean_size(log);
        }
    });
    field.metric = std::make_shared<const MetricField>(std::move(logs));
    return field;
}
template SizingField sizing_from_metric(const Grid&, const Placement&, const float*, const Run&);
template SizingField sizing_from_metric(const Grid&, const Placement&, const double*, const Run&);

SizingField constant_metric(const Grid& grid, const Placement& placement, const Tensor& metric)
{
    if (!metric.matrix().allFinite())
        throw Error(CLEFT_ERROR_NOT_FINITE, "the metric has a NaN or infinite number");
    const Tensor log = checked_log(metric, placement, "the metric");
    SizingField field{grid, Array<float>(grid.size(), mean_size(log))};
    field.metric = std::make_shared<const MetricField>(MetricField{grid, Array<Six>(grid.size(), to_six(log))});
    return field;
}

SizingField sizing_of_tensors(const Grid& grid, const Array<Tensor>& metric, double gradation, const Run& run)
{
    SizingField field{grid, Array<float>(grid.size()), gradation};
    MetricField logs{grid, Array<Six>(grid.size())};
    parallel_for(run, grid.size(), kTensorsAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t v = begin; v < end; ++v) {
            const Tensor log = cleft::log(metric[v]);
            logs.log[v] = to_six(log);
            field.h[v] = mean_size(log);
        }
    });
    field.metric = std::make_shared<const MetricField>(std::move(logs));
    return field;
}

Tensor world_metric(const SizingField& field, const Placement& placement, int64_t voxel)
{
    const Mat3 inverse = placement.linear.inverse();
    return cleft::to_tensor(Mat3(inverse.transpose() * exp(to_tensor(field.metric->log[voxel])).matrix() * inverse));
}

SizingField greatest_sizes(const SizingField& field, const Run& run)
{
    SizingField sizes{field.grid, field.h, field.gradation};
    if (field.metric)
        parallel_for(run, sizes.h.count(), kTensorsAtOnce, [&](int64_t begin, int64_t end) {
            for (int64_t v = begin; v < end; ++v)
                sizes.h[v] = static_cast<float>(size_of(eigenvalues(to_tensor(field.metric->log[v]))[0]));
        });
    return sizes;
}

void bound_metric(SizingField& field, double least, double greatest, const Run& run)
{
    const double most = least > 0 ? -2 * std::log(least) : HUGE_VAL;
    const double fewest = greatest > 0 ? -2 * std::log(greatest) : -HUGE_VAL;
    change_eigenvalues(field, run,
                       [&](const Vec3& logs, int64_t) -> Vec3 { return logs.cwiseMax(fewest).cwiseMin(most); });
}

void intersect_metric(SizingField& field, const SizingField& other, const Run& run)
{
    if (other.metric)
        intersect_metrics(field, *other.metric, run);
    else
        change_eigenvalues(field, run, [&](const Vec3& logs, int64_t v) -> Vec3 {
            return logs.cwiseMax(-2 * std::log(double{other.h[v]}));
        });
}

}  // namespace cleft
