// The greatest field below given values whose gradient is limited.
#pragma once

#include "base/array.hpp"
#include "sizing/voxel_rows.hpp"

namespace cleft
{

// h(x) = min over the voxels b of (h(b) + gradation |x - b|), in place: the lower envelope of a cone at each voxel.
// The result is gradation-Lipschitz between any two of 26 neighbours, up to rounding, nowhere below the exact envelope
// and above it by a small part of a percent at most.
void limit_gradient(const Grid& grid, double gradation, Array<float>& h, const Run& run);

}  // namespace cleft
