// From curvatures to sizes, voxel by voxel.
#include "sizing/surface_sizes.hpp"

#include "sizing/line_curvature.hpp"
#include "sizing/surface_curvature.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

// With 0.7, triangles of balls and tori in exact functions are off by 0.8 to 1.0 of the error at most, and from labels
// by 1.2, of which the steps of the voxels are the most. With 1 they were off by up to twice the error.
constexpr double kShareOfEdge = 0.7;

double greatest_size(double error, double curvature) { return kShareOfEdge * std::sqrt(8 * error / curvature); }

void add_sizes(const Grid& grid, const Array<CurvedPoint>& points, double error, Array<SizeLimit>& sizes)
{
    for (const CurvedPoint& point : points) {
        if (!(point.curvature > 0))
            continue;
        FixedArray<int32_t, 3> at{};
        for (int a = 0; a < 3; ++a)
            at[a] = std::clamp(static_cast<int32_t>(point.x[a] / grid.spacing[a]), 0, grid.dims[a] - 1);
        sizes.push_back({grid.index(at[0], at[1], at[2]), static_cast<float>(greatest_size(error, point.curvature))});
    }
}

}  // namespace

Array<SizeLimit> sizes_for_error(const Volume& volume, double error, const Run& run)
{
    Array<SizeLimit> sizes;
    add_sizes(volume.grid(), surface_curvatures(volume, run), error, sizes);
    add_sizes(volume.grid(), line_curvatures(volume, run), error, sizes);
    return sizes;
}

}  // namespace cleft
