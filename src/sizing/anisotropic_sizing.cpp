// Makes a tensor of each bend of an interface, and spreads them by the gradation.
#include "sizing/anisotropic_sizing.hpp"

#include "base/number_text.hpp"
#include "base/parallel.hpp"
#include "base/stage.hpp"
#include "sizing/metric_gradation.hpp"
#include "sizing/metric_sizing.hpp"
#include "sizing/surface_curvature.hpp"
#include "sizing/volume_sizing.hpp"
#include "sizing/voxel_of_point.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

// How far an edge along the interface may leave it, in sizes across it.
constexpr double kSagitta = 0.1;
// Voxels that a thread takes. The number changes the time alone.
constexpr int64_t kVoxelsMeasured = 1 << 12;

double inverse_square_of(double size) { return 1 / (size * size); }

Tensor across(const Vec3& direction, double size)
{
    return to_tensor(Mat3(inverse_square_of(size) * direction * direction.transpose()));
}

// Along a direction of this curvature, where the size across is `size`. Where the curvature is not known, they are the
// same.
double size_along(double size, double curvature, double ratio)
{
    if (curvature < 0)
        return size;
    const double bent = curvature > 0 ? std::sqrt(8 * kSagitta * size / curvature) : HUGE_VAL;
    return std::clamp(bent, size, ratio * size);
}

Tensor metric_of(const Bend& bend, double size, double ratio)
{
    // The directions are those of a window; at the point itself the normal turns a little.
    const Vec3 first = bend.along[0] - bend.normal.dot(bend.along[0]) * bend.normal;
    if (bend.curvature[1] < 0 || !(first.norm() > 0.5))
        return {inverse_square_of(size), 0, 0, inverse_square_of(size), 0, inverse_square_of(size)};
    const Vec3 along = first.normalized();
    return across(bend.normal, size) + across(along, size_along(size, bend.curvature[0], ratio)) +
           across(bend.normal.cross(along), size_along(size, bend.curvature[1], ratio));
}

// No size is less than the voxel is long there, and none by more than the ratio greater than the least for that.
Vec3 least_sizes(const Grid& grid, const SizingOptions& options)
{
    const double least = std::max(options.size_min, grid.spacing.minCoeff());
    return grid.spacing.cwiseMax(least).cwiseMin(options.anisotropy * least);
}

// The tensor whose sizes along the axes are at least these: its eigenvalues are bounded in the frame of the voxel.
Tensor bounded(const Tensor& metric, const Vec3& least)
{
    const Mat3 in_voxels = least.asDiagonal() * metric.matrix() * least.asDiagonal();
    Eigen::SelfAdjointEigenSolver<Mat3> axes;
    axes.computeDirect(in_voxels);
    if (axes.eigenvalues()[2] <= 1)
        return metric;
    const Mat3 back = least.cwiseInverse().asDiagonal() * axes.eigenvectors();
    return to_tensor(Mat3(back * axes.eigenvalues().cwiseMin(1).asDiagonal() * back.transpose()));
}

// What sizes are asked for if features may be greater by the ratio.
SizingField widest(const Volume& volume, SizingOptions options, const Run& run)
{
    options.feature_scale *= options.anisotropy;
    options.surface_error = 0;
    options.max_tets = 0;
    Run quiet = run;
    quiet.metrics = nullptr;
    return compute_sizing(volume, options, quiet);
}

Array<Tensor> isotropic_metrics(const SizingField& field, const Run& run)
{
    Array<Tensor> metrics(field.h.size());
    parallel_for(run, field.h.count(), kVoxelsMeasured, [&](int64_t begin, int64_t end) {
        for (int64_t v = begin; v < end; ++v) {
            const double m = inverse_square_of(double{field.h[v]});
            metrics[v] = {m, 0, 0, m, 0, m};
        }
    });
    return metrics;
}

}  // namespace

SizingField anisotropic_sizing(const Volume& volume, const SizingOptions& options, const Run& run)
{
    Steps steps(run,
                {{nullptr, 30}, {nullptr, 30}, {"sizing: curvature", 10}, {"sizing: gradation", 25}, {nullptr, 5}});
    SizingOptions isotropic = options;
    isotropic.max_tets = 0;
    const SizingField sizes = compute_sizing(volume, isotropic, steps.next());
    const SizingField wide = widest(volume, options, steps.next());
    const Run of_metrics = steps.next();
    Array<Tensor> metrics = isotropic_metrics(wide, of_metrics);
    for (const Bend& bend : surface_bends(volume, of_metrics)) {
        const int64_t v = voxel_of_point(volume.grid(), bend.x);
        metrics[v] = intersection(metrics[v], metric_of(bend, double{sizes.h[v]}, options.anisotropy));
    }
    limit_metric_gradation(volume.grid(), options.gradation, metrics, steps.next());
    const Vec3 least = least_sizes(volume.grid(), options);
    const Run of_field = steps.next();
    parallel_for(of_field, metrics.count(), kVoxelsMeasured, [&](int64_t begin, int64_t end) {
        for (int64_t v = begin; v < end; ++v)
            metrics[v] = bounded(metrics[v], least);
    });
    return sizing_of_tensors(volume.grid(), metrics, options.gradation, of_field);
}

}  // namespace cleft
