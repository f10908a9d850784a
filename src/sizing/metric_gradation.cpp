// Scans all rows of voxels along each axis, there and back, until nothing changes.
#include "sizing/metric_gradation.hpp"

#include "base/parallel.hpp"

#include <atomic>
#include <cmath>

namespace cleft
{

namespace
{

// Of scans along all axes. The first does nearly all; metrics that have to turn around corners need the others.
constexpr int kMostRounds = 4;
// Rows that a thread takes. The number changes the time alone.
constexpr int64_t kRowsScanned = 16;
// A metric that is less by so small a share stays: intersections would go on for nothing.
constexpr double kNearlyCovered = 0.99;

class RowScan
{
public:
    RowScan(const Grid& grid, int axis, double gradation, Array<Tensor>& metric)
        : dims_(grid.dims), strides_(grid.strides()), axis_(axis), gradation_(gradation), metric_(metric)
    {
        step_[axis] = grid.spacing[axis];
    }

    int64_t rows() const { return metric_.count() / std::max(1, dims_[axis_]); }

    // There and back. True if something changed.
    bool scan(int64_t row)
    {
        const int b = axis_ == 0 ? 1 : 0, c = axis_ == 2 ? 1 : 2;
        const int64_t first = row % dims_[b] * strides_[b] + row / dims_[b] * strides_[c];
        const int64_t stride = strides_[axis_];
        bool changed = false;
        for (int32_t i = 1; i < dims_[axis_]; ++i)
            changed |= lower(first + i * stride, metric_[first + (i - 1) * stride]);
        for (int32_t i = dims_[axis_] - 1; i > 0; --i)
            changed |= lower(first + (i - 1) * stride, metric_[first + i * stride]);
        return changed;
    }

private:
    bool lower(int64_t voxel, const Tensor& from)
    {
        const double growth = 1 + gradation_ * std::sqrt(square(from, step_));
        const Tensor grown = 1 / (growth * growth) * from;
        if (covers(metric_[voxel], kNearlyCovered * grown))
            return false;
        metric_[voxel] = intersection(metric_[voxel], grown);
        return true;
    }

    FixedArray<int32_t, 3> dims_;
    FixedArray<int64_t, 3> strides_;
    int axis_;
    double gradation_;
    Vec3 step_ = Vec3::Zero();
    Array<Tensor>& metric_;
};

}  // namespace

void limit_metric_gradation(const Grid& grid, double gradation, Array<Tensor>& metric, const Run& run)
{
    for (int round = 0; round < kMostRounds; ++round) {
        std::atomic<bool> changed{false};
        for (int axis = 0; axis < 3; ++axis) {
            RowScan rows(grid, axis, gradation, metric);
            parallel_for(run, rows.rows(), kRowsScanned, [&](int64_t begin, int64_t end) {
                for (int64_t row = begin; row < end; ++row)
                    if (rows.scan(row))
                        changed = true;
            });
            run.report((3.0 * round + axis + 1) / (3 * kMostRounds));
        }
        if (!changed)
            return;
    }
}

}  // namespace cleft
