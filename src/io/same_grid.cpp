// Compares two grids by the places of their corners.
#include "io/same_grid.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cleft::io
{

namespace
{

std::string text_of(const std::array<int64_t, 3>& dims)
{
    return std::to_string(dims[0]) + " x " + std::to_string(dims[1]) + " x " + std::to_string(dims[2]);
}

// The greatest distance between the places that the two maps give to a corner, in voxels.
double greatest_shift(const VoxelGrid& grid, const VoxelGrid& other)
{
    const std::array<double, 12>& a = other.affine;
    const std::array<double, 12>& b = grid.affine;
    double shift = 0;
    // Two affine maps differ most at a corner of the box, so eight points suffice.
    for (int corner = 0; corner < 8; ++corner) {
        double squared = 0;
        for (size_t row = 0; row < 3; ++row) {
            double way = a[4 * row + 3] - b[4 * row + 3];
            for (size_t axis = 0; axis < 3; ++axis)
                if (corner >> axis & 1)
                    way += (a[4 * row + axis] - b[4 * row + axis]) * static_cast<double>(grid.dims[axis]);
            squared += way * way;
        }
        shift = std::max(shift, std::sqrt(squared));
    }
    // In units of the shortest step, since a shift along it moves the voxels most.
    double voxel = std::numeric_limits<double>::max();
    for (size_t axis = 0; axis < 3; ++axis)
        voxel = std::min(voxel, std::hypot(a[axis], a[4 + axis], a[8 + axis]));
    return shift / voxel;
}

}  // namespace

void check_same_grid(const VoxelGrid& grid, const VoxelGrid& other, const std::string& name)
{
    // Headers in single precision differ by 1e-4 of a voxel on large grids. A field that is shifted
    // by a tenth is wrong already.
    constexpr double kTolerance = 0.01;
    if (grid.dims != other.dims)
        throw Error(CLEFT_ERROR_ARGUMENT,
                    "it has " + text_of(grid.dims) + " voxels, but " + name + " has " + text_of(other.dims));
    if (greatest_shift(grid, other) > kTolerance)
        throw Error(CLEFT_ERROR_ARGUMENT, "its voxels are not at the places of those of " + name);
}

}  // namespace cleft::io
