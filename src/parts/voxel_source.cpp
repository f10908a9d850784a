// Windows as arrays of bytes, in the type of the voxels.
#include "parts/voxel_source.hpp"

namespace cleft
{

namespace
{

int64_t bytes_of(VoxelType type)
{
    switch (type) {
        case VoxelType::uint8:
            return 1;
        case VoxelType::uint16:
        case VoxelType::int16:
            return 2;
        default:
            return 4;
    }
}

}  // namespace

Array<unsigned char> read_window(const VoxelSource& source, const Window& window)
{
    Array<unsigned char> voxels(window.size() * bytes_of(source.type));
    source.read(window, voxels.data());
    return voxels;
}

}  // namespace cleft
