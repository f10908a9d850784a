// The direction of a scan over the voxels. The gradient limit takes several, in different directions.
#pragma once

#include "base/fixed_array.hpp"
#include "base/grid.hpp"

#include <cstdint>

namespace cleft
{

// Scanned coordinates count up from 0 in the direction of the scan.
struct RasterScan {
    FixedArray<int32_t, 3> sign;  // along each axis

    int32_t at(int axis, int32_t step, const Grid& grid) const
    {
        return sign[axis] > 0 ? step : grid.dims[axis] - 1 - step;
    }
};

}  // namespace cleft
