// Label maps and functions that the tests of the volume stage are made of.
#pragma once

#include "volume/volume.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace cleft::test
{

struct LabelImage {
    Grid grid;
    std::vector<int32_t> voxels;
};

// label(i, j, k) at every voxel.
template <class Label>
LabelImage label_image(const std::array<int32_t, 3>& dims, const Label& label)
{
    LabelImage image;
    image.grid.dims = dims;
    for (int32_t k = 0; k < dims[2]; ++k)
        for (int32_t j = 0; j < dims[1]; ++j)
            for (int32_t i = 0; i < dims[0]; ++i)
                image.voxels.push_back(label(i, j, k));
    return image;
}

// A small generator of random numbers of its own: the same everywhere.
struct Random {
    uint64_t state = 1;
    uint32_t next()
    {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<uint32_t>(state >> 33);
    }
    int32_t below(int32_t n) { return static_cast<int32_t>(next() % static_cast<uint32_t>(n)); }
    double unit() { return next() / 2147483648.0; }
};

inline LabelImage noise_image(const std::array<int32_t, 3>& dims, int32_t labels, uint64_t seed = 1)
{
    Random random{seed};
    return label_image(dims, [&](int32_t, int32_t, int32_t) { return random.below(labels); });
}

inline LabelImage checkerboard_image(const std::array<int32_t, 3>& dims)
{
    return label_image(dims, [](int32_t i, int32_t j, int32_t k) { return (i + j + k) & 1; });
}

inline Volume volume_of(const LabelImage& image, int kernel = 5, int threads = 1)
{
    Run run;
    run.threads = threads;
    return Volume::from_labels(VoxelType::int32, image.voxels.data(), image.grid, kernel, run);
}

// Number of voxel centres at which the field does not hold the voxel's own material.
inline int64_t lost_centres(const Volume& volume)
{
    const Grid& grid = volume.grid();
    int64_t lost = 0, voxel = 0;
    for (int32_t k = 0; k < grid.dims[2]; ++k)
        for (int32_t j = 0; j < grid.dims[1]; ++j)
            for (int32_t i = 0; i < grid.dims[0]; ++i, ++voxel)
                lost += volume.material_at(grid.centre(i, j, k)) != volume.voxel_material(voxel);
    return lost;
}

}  // namespace cleft::test
