// The medial axis of parts that are one or two voxels thick, where interface points are too near to each other to tell
// opposite sides by their normals: sheets, rods and single voxels.
#pragma once

#include "base/array.hpp"
#include "sizing/interface_points.hpp"

#include <cstdint>

namespace cleft
{

// For each voxel the place of the medial axis that it holds (see medial_axis.hpp), or 0.
Array<uint8_t> thin_medial_places(const Labelling& labelling, const InterfacePoints& points, const Run& run);

}  // namespace cleft
