// What each label of a volume has in a mesh that ranks share.
#pragma once

#include "parts/mesh_part.hpp"
#include "volume/kept_materials.hpp"
#include "volume/volume.hpp"

namespace cleft
{

// Of the whole mesh and the whole volume.
struct PartLabel {
    UserLabel label{};
    bool is_kept = true;  // not left out of the mesh
    int64_t voxels = 0, tets = 0;
    double voxel_volume = 0, mesh_volume = 0;
};

// Ascending, in the frame of the voxels; the same on all ranks. The part has labels in the place of materials. `kept`:
// by the place in `labels`.
Array<PartLabel> part_labels(const LabelCounts& labels, const KeptMaterials& kept, const Grid& grid,
                             const MeshPart& part, Exchange& exchange);

}  // namespace cleft
