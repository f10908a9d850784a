// Finds the weights of a label map.
#pragma once

#include "base/run.hpp"
#include "volume/label_map.hpp"

namespace cleft
{

// Sets A and B in the band, given the depths:
// 1. a bump B for voxels of thin structures, which the kernel would wipe out;
// 2. rounds of feedback on A: where a material holds less than its voxels near a voxel, the voxel gains weight;
// 3. the B that is lacking for every voxel centre to keep its material.
template <class Label>
void find_weights(LabelMap<Label>& map, const Run& run);

}  // namespace cleft
