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
    // What is made of a window numbers its voxels in 32 bits.
    if (window.size() > INT32_MAX)
        throw Error(CLEFT_ERROR_TOO_LARGE, std::to_string(window.size()) + " voxels are needed at once, from plane " +
                                               std::to_string(window.first[2]) + " to plane " +
                                               std::to_string(window.first[2] + window.count[2] - 1) +
                                               ", more than 2147483647: set a smaller block");
    Array<unsigned char> voxels(window.size() * bytes_of(source.type));
    source.read(window, voxels.data());
    return voxels;
}

}  // namespace cleft
