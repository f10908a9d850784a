// Splits the affine of a user into the spacing of the grid and what the local frame does not know (decision 1).
#include "volume/frame.hpp"

#include "base/error.hpp"
#include "base/ordinal.hpp"
#include "volume/limits.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <string>

namespace cleft
{

namespace
{

std::string voxels_along(size_t axis) { return std::string("the number of voxels along ") + "xyz"[axis] + " is "; }

Grid checked_grid(const int64_t dims[3])
{
    Grid grid;
    for (size_t axis = 0; axis < 3; ++axis) {
        if (dims[axis] < 1)
            throw Error(CLEFT_ERROR_ARGUMENT,
                        voxels_along(axis) + std::to_string(dims[axis]) + "; it must be at least 1");
        // A quarter of the range: sums of a few indices along one axis stay within int32_t.
        if (dims[axis] > INT32_MAX / 4)
            throw Error(CLEFT_ERROR_TOO_LARGE,
                        voxels_along(axis) + std::to_string(dims[axis]) + ", too many for 32-bit numbering");
        grid.dims[axis] = static_cast<int32_t>(dims[axis]);
    }
    return grid;
}

// Exact for a column along an axis, and safe from overflow.
// A spacing of 0.1 must stay 0.1, and the square of a length may overflow where the length does not.
double length_of(const Vec3& column)
{
    const double most = column.cwiseAbs().maxCoeff();
    return most > 0 ? most * (column / most).norm() : 0;
}

}  // namespace

Vec3 Frame::to_local(const Vec3& world) const
{
    Vec3 local = inverse * (world - offset);
    const Vec3 extent = grid.extent();
    // The affine far from the origin has lost digits before its inverse sees the point, so 1e-9 alone would not do
    // there.
    const double rounding = 2 * std::numeric_limits<double>::epsilon() * world.cwiseAbs().maxCoeff();
    const double tolerance = 1e-9 * extent.maxCoeff() + rounding * inverse.cwiseAbs().maxCoeff();
    // Later stages compare coordinates with 0 and the extent exactly: only an exact one keeps its point in the wall.
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(local[axis]) < tolerance)
            local[axis] = 0;
        else if (std::abs(local[axis] - extent[axis]) < tolerance)
            local[axis] = extent[axis];
    }
    return local;
}

bool fits_in_one_piece(const Grid& grid)
{
    return double(grid.dims[0]) * double(grid.dims[1]) * double(grid.dims[2]) <= INT32_MAX;
}

Frame make_frame(const int64_t dims[3], const double* affine)
{
    if (!fits_in_one_piece(checked_grid(dims)))
        throw Error(CLEFT_ERROR_TOO_LARGE, "the volume has more than 2147483647 voxels");
    return make_frame_of_parts(dims, affine);
}

Frame make_frame_of_parts(const int64_t dims[3], const double* affine)
{
    static const double unit[12] = {1, 0, 0, 0.5, 0, 1, 0, 0.5, 0, 0, 1, 0.5};
    const double* a = affine ? affine : unit;
    Frame frame;
    frame.grid = checked_grid(dims);
    Mat3 columns;
    Vec3 origin;
    for (int i = 0; i < 12; ++i) {
        if (!std::isfinite(a[i]))
            throw Error(CLEFT_ERROR_NOT_FINITE, "the affine has NaN or infinity in its " + ordinal(i / 4) + " row, " +
                                                    ordinal(i % 4) + " column");
        frame.affine[i] = a[i];
        if (i % 4 == 3)
            origin[i / 4] = a[i];
        else
            columns(i / 4, i % 4) = a[i];
    }
    for (int axis = 0; axis < 3; ++axis) {
        frame.grid.spacing[axis] = length_of(columns.col(axis));
        if (!(frame.grid.spacing[axis] > 0) || !std::isfinite(frame.grid.spacing[axis]))
            throw Error(CLEFT_ERROR_ARGUMENT,
                        "the affine has no length along the " + ordinal(axis) + " axis of the voxels");
        frame.linear.col(axis) = columns.col(axis) / frame.grid.spacing[axis];
    }
    // The columns have length 1 here, so this is the volume of a cell with unit edges. Below the limit, the inverse
    // would lose six or more of sixteen digits.
    if (std::abs(frame.linear.determinant()) < 1e-6)
        throw Error(CLEFT_ERROR_ARGUMENT, "the affine flattens the volume: its columns lie in one plane");
    // The affine places the centre of the first voxel. The box begins at its least corner, half a voxel before.
    frame.offset = origin - columns * Vec3(0.5, 0.5, 0.5);
    frame.inverse = frame.linear.inverse();
    check_limits(frame);
    return frame;
}

}  // namespace cleft
