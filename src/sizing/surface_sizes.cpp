// From curvatures to sizes, voxel by voxel.
#include "sizing/surface_sizes.hpp"

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

void add_sizes(const Grid& grid, const Array<CurvedPoint>& points, double error, Array<SizeLimit>& sizes)
{
    for (const CurvedPoint& point : points) {
        if (!(point.curvature > 0))
            continue;
        sizes.push_back({voxel_of_point(grid, point.x), static_cast<float>(greatest_size(error, point.curvature))});
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
