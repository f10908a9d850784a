// Do the volumes of a mesh come near those of its voxels?
#pragma once

#include "mesh/tet_mesh.hpp"
#include "volume/kept_materials.hpp"
#include "volume/volume.hpp"

namespace cleft
{

// Warns, in one sentence for all, of kept labels of some size whose volume in the mesh is not that of their voxels.
// A mesh that does not fill the box says nothing.
// `volumes`: of each material in the mesh.
void warn_of_volume_differences(const Grid& grid, const LabelCounts& voxels, const Array<double>& volumes,
                                const KeptMaterials& kept, const Run& run);

}  // namespace cleft
