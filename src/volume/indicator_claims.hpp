// Does one indicator function win at each voxel?
#pragma once

#include "base/array.hpp"
#include "base/grid.hpp"
#include "base/run.hpp"

namespace cleft
{

// Of functions with values at the voxels of a grid. Functions of two values are masks: an Error if voxels are
// in none of them, a warning if some are in several. Of other functions, a warning if several are the greatest all over
// a region: where the first of them holds there, nobody said so. Interfaces on which voxel centres happen to lie are
// no region. Of a single function, a warning if it is a mask.
void check_claims(const Array<Array<float>>& fields, const Grid& grid, const Run& run);

}  // namespace cleft
