// From positions in the local frame of a grid to positions among its voxels.
#pragma once

#include "base/grid.hpp"

#include <algorithm>

namespace cleft
{

// Voxel centres are at integers. A point outside the box is moved to the nearest point of the box, NaN to its least
// corner.
inline FixedArray<double, 3> voxel_position(const Grid& grid, const Vec3& x)
{
    FixedArray<double, 3> u;
    for (int a = 0; a < 3; ++a) {
        const double t = x[a] / grid.spacing[a];
        // The comparison is false for NaN, which a minimum and a maximum would pass on, and an index made of it is
        // undefined.
        u[a] = (t > 0 ? std::min<double>(t, grid.dims[a]) : 0.0) - 0.5;
    }
    return u;
}

// The voxel with the nearest centre, of a position that voxel_position() gave.
inline FixedArray<int32_t, 3> nearest_voxel(const Grid& grid, const FixedArray<double, 3>& u)
{
    FixedArray<int32_t, 3> n;
    for (int a = 0; a < 3; ++a) {
        // A cast truncates towards zero. This is the floor, since u is at least -1/2.
        n[a] = std::min(static_cast<int32_t>(u[a] + 0.5), grid.dims[a] - 1);
        CLEFT_ASSERT(n[a] >= 0);
    }
    return n;
}

}  // namespace cleft
