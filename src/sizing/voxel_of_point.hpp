// The voxel that a point of the box lies in.
#pragma once

#include "base/grid.hpp"

#include <algorithm>

namespace cleft
{

// The outermost voxel for a point on the far side of the box, or beyond it by rounding.
inline int64_t voxel_of_point(const Grid& grid, const Vec3& x)
{
    FixedArray<int32_t, 3> at{};
    for (int a = 0; a < 3; ++a)
        at[a] = std::clamp(static_cast<int32_t>(x[a] / grid.spacing[a]), 0, grid.dims[a] - 1);
    return grid.index(at[0], at[1], at[2]);
}

}  // namespace cleft
