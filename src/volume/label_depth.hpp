// How far each voxel of a label map lies inside its material.
#pragma once

#include "base/run.hpp"
#include "volume/label_map.hpp"

namespace cleft
{

// Sets `weight` to one and `code` to the depth of each voxel, and to B = 0 in the band.
template <class Label>
void find_depths(LabelMap<Label>& map, const Run& run);

}  // namespace cleft
