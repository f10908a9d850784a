// Which materials touch in the voxels.
#pragma once

#include "base/array.hpp"
#include "volume/voxel_components.hpp"

#include <array>

namespace cleft
{

// By pair of different materials: 1 if a voxel of the one shares a face or an edge with a voxel of the other. (A corner
// is no contact: through it, a gap of one voxel goes on.) `pairs` ascend, each with the lesser material first.
Array<uint8_t> voxels_touch(const Grid& grid, const VoxelComponents& components,
                            const Array<std::array<Material, 2>>& pairs, const Run& run);

}  // namespace cleft
