// Connected components of the voxels of one material.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "volume/volume.hpp"

namespace cleft
{

struct VoxelComponents {
    Array<int32_t> of_voxel;
    // By component; components are in the order of their first voxels.
    Array<Material> material;
    Array<int64_t> voxels;
};

// Connected over faces.
VoxelComponents voxel_components(const Volume& volume, const Run& run);

}  // namespace cleft
