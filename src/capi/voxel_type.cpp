// From numbers of the C interface.
#include "capi/voxel_type.hpp"

#include "base/error.hpp"

#include <string>

namespace cleft::capi
{

// A switch, not a cast: the number comes from a caller and may be any.
VoxelType voxel_type(cleft_type type)
{
    switch (type) {
        case CLEFT_TYPE_UINT8:
            return VoxelType::uint8;
        case CLEFT_TYPE_UINT16:
            return VoxelType::uint16;
        case CLEFT_TYPE_INT16:
            return VoxelType::int16;
        case CLEFT_TYPE_UINT32:
            return VoxelType::uint32;
        case CLEFT_TYPE_INT32:
            return VoxelType::int32;
        default:
            throw Error(CLEFT_ERROR_ARGUMENT,
                        "type is " + std::to_string(type) + ", which is no type of a label map's voxels");
    }
}

}  // namespace cleft::capi
