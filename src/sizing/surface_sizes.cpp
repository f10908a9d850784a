// From curvatures to sizes, voxel by voxel.
#include "sizing/surface_sizes.hpp"

#include "base/collect.hpp"
#include "sizing/line_curvature.hpp"
#include "sizing/surface_curvature.hpp"
#include "sizing/voxel_of_point.hpp"

#include <cmath>

namespace cleft
{

namespace
{

// With 0.7, triangles of balls and tori in exact functions are off by 0.8 to 1.0 of the error at most, and from labels
// by 1.2, of which the steps of the voxels are the most. With 1 they were off by up to twice the error.
constexpr double kShareOfEdge = 0.7;

double greatest_size(double error, double curvature) { return kShareOfEdge * std::sqrt(8 * error / curvature); }

Array<SizeLimit> sizes_at(const Grid& grid, const Array<CurvedPoint>& points, double error, const Run& run)
{
    constexpr int64_t kPointsAtOnce = 4096;  // the number changes the time alone
    return collect<SizeLimit>(
        run, points.count(), kPointsAtOnce, [&](int64_t begin, int64_t end, Array<SizeLimit>& sizes) {
            for (int64_t i = begin; i < end; ++i)
                if (const auto& [x, curvature] = points[i]; curvature > 0)
                    sizes.push_back({voxel_of_point(grid, x), static_cast<float>(greatest_size(error, curvature))});
        });
}

}  // namespace

Array<SizeLimit> sizes_for_error(const Volume& volume, double error, const Run& run)
{
    Array<SizeLimit> sizes = sizes_at(volume.grid(), surface_curvatures(volume, run), error, run);
    const Array<SizeLimit> of_lines = sizes_at(volume.grid(), line_curvatures(volume, run), error, run);
    sizes.insert(sizes.end(), of_lines.begin(), of_lines.end());
    return sizes;
}

}  // namespace cleft
