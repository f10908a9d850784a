// Reports the shapes that improving could not bring to its goal.
#pragma once

#include "pipeline/pipeline.hpp"

namespace cleft
{

// Warns in one sentence if a tetrahedron that is kept has an angle beyond the goal, in the frame of the voxel axes, and
// in another one if only its radius ratio is.
void warn_of_missed_goal(const Volume& volume, const LabelledMesh& mesh, const PipelineOptions& options,
                         const Run& run);

}  // namespace cleft
