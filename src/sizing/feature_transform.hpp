// The exact Euclidean feature transform: for each voxel the nearest site, in time linear in the number of voxels.
#pragma once

#include "base/array.hpp"
#include "sizing/voxel_rows.hpp"

#include <cstdint>

namespace cleft
{

// In: nearest[v] = v for a site v, -1 for any other voxel. Out: the site whose centre is nearest to the centre of v,
// with the grid's spacing; of sites at equal distance always the same one. All -1 if there is no site.
// Where no site is within `reach`, in world units, -1 stays: a part of the grid without any costs next to nothing.
void feature_transform(const Grid& grid, double reach, Array<int32_t>& nearest, const Run& run);

}  // namespace cleft
