// Where a file has the voxels of an image: for reading a part of them.
#pragma once

#include "io/voxel_data.hpp"

namespace cleft::io
{

struct StoredImage {
    Image image;  // all but its voxels
    VoxelData data;
    bool is_followed = false;  // may other data stand behind the voxels?
};

}  // namespace cleft::io
