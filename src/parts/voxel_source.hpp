// A label map whose voxels are read window by window.
#pragma once

#include "base/array.hpp"
#include "volume/volume.hpp"

#include <functional>

namespace cleft
{

// The voxels first .. first + count - 1 along each axis.
struct Window {
    FixedArray<int32_t, 3> first{0, 0, 0};
    FixedArray<int32_t, 3> count{0, 0, 0};

    int64_t size() const { return int64_t{count[0]} * count[1] * count[2]; }
};

struct VoxelSource {
    VoxelType type = VoxelType::uint8;
    // Reads a window to `voxels`, x fastest. Throws where it cannot.
    std::function<void(const Window& window, void* voxels)> read;
};

// The bytes of a window.
Array<unsigned char> read_window(const VoxelSource& source, const Window& window);

}  // namespace cleft
