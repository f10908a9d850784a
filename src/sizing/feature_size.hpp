// The local feature size at the material interfaces of a volume (section 3 of the paper, Sizing Field).
#pragma once

#include "base/array.hpp"
#include "sizing/labelling.hpp"
#include "sizing/voxel_rows.hpp"

#include <cstdint>

namespace cleft
{

// The distance from the interface to the medial axis, for each voxel that has a neighbour of another material across
// a face, ascending by voxel. Infinite where there is no medial axis, as for a single flat interface.
struct FeatureSizes {
    Array<int32_t> voxel;
    Array<float> size;
    int64_t medial_voxels = 0;  // of those that were looked at: far ones matter to no interface
};

// In world units. Empty if all voxels are of one material. A size above `most` may be any other above it.
FeatureSizes local_feature_sizes(const Labelling& labelling, double most, const Run& run);

}  // namespace cleft
