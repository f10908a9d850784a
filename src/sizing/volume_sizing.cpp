// Lets the stage read the materials of a Volume, which it knows only as a Labelling.
#include "sizing/volume_sizing.hpp"

#include "sizing/compute.hpp"

namespace cleft
{

SizingField compute_sizing(const Volume& volume, const SizingOptions& options, const Run& run)
{
    const auto read = [&volume](int64_t first, int64_t count, Material* out) {
        volume.voxel_materials(first, count, out);
    };
    return compute_sizing(Labelling{volume.grid(), read}, options, run);
}

}  // namespace cleft
