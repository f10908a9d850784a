// The voxel grid and its local frame: axes along the voxel rows, lengths in world units, the least corner of the
// first voxel at the origin. All stages work in this frame; cleft_mesh turns results into world coordinates.
#pragma once

#include "base/fixed_array.hpp"
#include "base/vec.hpp"

#include <cstdint>

namespace cleft
{

// Planes of voxels across the last axis: first .. first + count - 1.
struct Planes {
    int32_t first = 0, count = 0;

    int32_t end() const { return first + count; }
    bool has(int32_t k) const { return k >= first && k < end(); }
};

struct Grid {
    FixedArray<int32_t, 3> dims{0, 0, 0};
    Vec3 spacing{1, 1, 1};

    int64_t size() const { return int64_t{dims[0]} * dims[1] * dims[2]; }
    bool has(int32_t i, int32_t j, int32_t k) const
    {
        return i >= 0 && i < dims[0] && j >= 0 && j < dims[1] && k >= 0 && k < dims[2];
    }
    int64_t index(int32_t i, int32_t j, int32_t k) const
    {
        CLEFT_ASSERT(has(i, j, k));
        return i + int64_t{dims[0]} * (j + int64_t{dims[1]} * k);
    }
    Vec3 centre(int32_t i, int32_t j, int32_t k) const { return Vec3(i + 0.5, j + 0.5, k + 0.5).cwiseProduct(spacing); }
    int64_t plane_size() const { return int64_t{dims[0]} * dims[1]; }
    // From a voxel to the next one along each axis.
    FixedArray<int64_t, 3> strides() const { return {1, dims[0], int64_t{dims[0]} * dims[1]}; }
    // The box is [0, extent]: it ends where the voxels end, not where their centres end.
    Vec3 extent() const { return Vec3(dims[0], dims[1], dims[2]).cwiseProduct(spacing); }
};

}  // namespace cleft
