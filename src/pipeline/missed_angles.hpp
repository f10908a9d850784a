// Reports dihedral angles that improving could not bring to its target.
#pragma once

#include "pipeline/pipeline.hpp"

namespace cleft
{

// Warns in one sentence if a tetrahedron that is kept has an angle beyond the target, in the frame of the voxel axes.
void warn_of_missed_angles(const Volume& volume, const LabelledMesh& mesh, const PipelineOptions& options,
                           const Run& run);

}  // namespace cleft
