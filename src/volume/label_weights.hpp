// Finds the weights of a label map.
#pragma once

#include "base/run.hpp"
#include "volume/label_map.hpp"

namespace cleft
{

// Sets `weight` to one and `code` to the depth of each voxel, and to B = 0 in the band.
template <class Label>
void find_depths(LabelMap<Label>& map, const Run& run);

// Sets A and B in the band, given the depths:
// 1. a bump B for voxels of thin structures, which the kernel would wipe out;
// 2. rounds of feedback on A: where a material holds less than its voxels near a voxel, the voxel gains weight;
// 3. the B that is lacking for every voxel centre to keep its material.
template <class Label>
void find_weights(LabelMap<Label>& map, const Run& run);

// Step 2, one round. The second damps what the first one overshot.
enum class FeedbackRound { first, second };
template <class Label>
void feed_back_volume(LabelMap<Label>& map, FeedbackRound round, const Run& run);

}  // namespace cleft
