// From the local frame of the stages to the world of the user, and back.
#pragma once

#include "base/fixed_array.hpp"
#include "base/grid.hpp"
#include "base/placement.hpp"

namespace cleft
{

struct Frame : Placement {
    Grid grid;
    FixedArray<double, 12> affine{};  // voxel index -> world, 3 rows of 4
    Mat3 inverse = Mat3::Identity();  // of linear

    // A point within 1e-9 of the longest side of a box plane, or within the rounding of a place far from the origin, is
    // put exactly on it, so that planes survive the way to the world and back.
    Vec3 to_local(const Vec3& world) const;
    bool flips() const { return linear.determinant() < 0; }
    bool is_that_of(const Frame& other) const { return grid.dims == other.grid.dims && affine == other.affine; }
};

// Do 32 bits number the voxels?
bool fits_in_one_piece(const Grid& grid);

// Throws an Error naming the entry at fault. `affine` may be null: spacing 1, the corner of the box at the origin.
Frame make_frame(const int64_t dims[3], const double* affine);
// Of a volume that nobody holds in one piece: it may have any number of voxels.
Frame make_frame_of_parts(const int64_t dims[3], const double* affine);

}  // namespace cleft
