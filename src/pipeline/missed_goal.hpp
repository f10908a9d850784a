// Reports the shapes that improving could not bring to its goal.
#pragma once

#include "parts/exchange.hpp"
#include "pipeline/pipeline.hpp"

namespace cleft
{

// Warns in one sentence if a tetrahedron that is kept has an angle beyond the goal, in the frame of the voxel axes, and
// in another one if only its radius ratio is. Ranks that have a mesh in pieces call it together, and the first one
// warns.
void warn_of_missed_goal(const Grid& grid, const LabelledMesh& mesh, const PipelineOptions& options, Exchange& exchange,
                         const Run& run);

}  // namespace cleft
