// The types of voxels that callers name.
#pragma once

#include "cleft/cleft.h"
#include "volume/volume.hpp"

namespace cleft::capi
{

// An Error if it is no type of a label map's voxels.
VoxelType voxel_type(cleft_type type);

}  // namespace cleft::capi
