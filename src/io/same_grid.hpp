// Do the voxels of two volumes lie at the same places?
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace cleft::io
{

struct VoxelGrid {
    std::array<int64_t, 3> dims;
    std::array<double, 12> affine;  // index to world, 3 rows of 4
};

// Throws Error(CLEFT_ERROR_ARGUMENT) about `grid` if it is not that of `other`, which is called `name`, within a
// hundredth of a voxel.
void check_same_grid(const VoxelGrid& grid, const VoxelGrid& other, const std::string& name);

}  // namespace cleft::io
