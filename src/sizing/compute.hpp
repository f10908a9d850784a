// The sizing field of anything whose voxels have materials: compute_sizing without the Volume.
#pragma once

#include "sizing/labelling.hpp"
#include "sizing/sizing.hpp"

#include <vector>

namespace cleft
{

// labels[m] is the user's value of material m, as in Volume::labels.
SizingField compute_sizing(const Labelling& labelling, const std::vector<int32_t>& labels, const SizingOptions& options,
                           const Run& run);

// Refuses a grid that no sizing field can have.
void check_sizing_grid(const Grid& grid);
// What to throw for a value that is not positive and finite.
Error bad_sizing_value(double value, int64_t voxel, const Grid& grid);

}  // namespace cleft
