// Parts of a label map: planes across its last axis.
#pragma once

#include "volume/label_map.hpp"

#include <functional>

namespace cleft
{

// What a voxel weighs depends on voxels within so many planes: the kernel sees three to each side, and each of the five
// steps of find_weights() looks through it; feedback looks at two more twice. See label_weights.cpp.
constexpr int32_t kPlanesOfWeight = 20;
// A sample sees so many planes around that of its voxel: the kernel, and a neighbour for bumps.
constexpr int32_t kPlanesOfSample = 4;

// Some planes and those around them, as far as there are any.
Planes planes_around(const Grid& whole, Planes planes, int32_t around);

// A plane of a map as bytes, and a map made of such planes, of which `sampled` may be sampled.
template <class Label>
Array<unsigned char> stored_plane(const LabelMap<Label>& map, int32_t k);
using StoredPlane = std::function<Array<unsigned char>(int32_t k)>;
template <class Label>
LabelMap<Label> restored(const Grid& whole, Planes sampled, int kernel, const StoredPlane& plane);

// Makes a map that was made of the planes from `first` on, as if they were all, the part of the whole map that they
// are. Weights are right only kPlanesOfWeight away from where it was cut.
template <class Label>
void place_in_whole(LabelMap<Label>& map, const Grid& whole, int32_t first);

// Planes as a map of their own, with the weights that they have.
template <class Label>
LabelMap<Label> cropped(const LabelMap<Label>& map, Planes planes);

}  // namespace cleft
