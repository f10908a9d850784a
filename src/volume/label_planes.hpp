// Parts of a label map: planes across its last axis.
#pragma once

#include "volume/label_map.hpp"

namespace cleft
{

// What a voxel weighs depends on voxels within so many planes: the kernel sees three to each side, and each of the five
// steps of find_weights() looks through it; feedback looks at two more twice. See label_weights.cpp.
constexpr int32_t kPlanesAround = 24;

// The planes that must be read so that `wanted` can be sampled as in the whole map.
Planes planes_around(const Grid& whole, Planes wanted);

// Makes a map that was made of the planes from `first` on, as if they were all, the part of the whole map that they
// are. Weights are right only kPlanesAround away from where it was cut, so these planes may be sampled.
template <class Label>
void place_in_whole(LabelMap<Label>& map, const Grid& whole, int32_t first);

// Planes as a map of their own, with the weights that they have.
template <class Label>
LabelMap<Label> cropped(const LabelMap<Label>& map, Planes planes);

}  // namespace cleft
