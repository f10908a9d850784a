// Cleaving and improving a background, in several tries if need be.
#pragma once

#include "mesh/local_mesh.hpp"
#include "pipeline/pipeline.hpp"

namespace cleft
{

// The cleaved and improved mesh. Where few tetrahedra of a small mesh stay short of the target angle, other tries are
// made and the best one is taken. Notes cleaving.*, improving.* of the try that is taken, and improving.tries.
LocalMesh improved_mesh(const Volume& volume, const TetMesh& background, const PipelineOptions& options,
                        const Run& run);

}  // namespace cleft
