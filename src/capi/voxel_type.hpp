// Volumes of label maps, as the entries that make one need them.
#pragma once

#include "capi/handles.hpp"

namespace cleft::capi
{

// An Error if it is no type of a label map's voxels.
VoxelType voxel_type(cleft_type type);

// The handle of a volume, with what callers are lent of it.
cleft_volume made_volume(const Frame& frame, Volume&& volume);

}  // namespace cleft::capi
