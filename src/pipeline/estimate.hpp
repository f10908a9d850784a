// What a mesh will come to before it is made: tetrahedra and memory.
#pragma once

#include "pipeline/expected_mesh.hpp"
#include "pipeline/pipeline.hpp"

namespace cleft
{

struct Estimate {
    ExpectedMesh mesh;
    double peak_bytes = 0;  // of the process that makes it, no less
};

// For the sizes that the options give.
Estimate estimate_from_volume(const Volume& volume, const PipelineOptions& options, const Run& run);
// For a sizing field, of which no mesh is made.
Estimate estimate_from_sizing(const Volume& volume, ScaledSizing sizing, const PipelineOptions& options,
                              const Run& run);
// For a background that is there.
Estimate estimate_from_background(const Volume& volume, const TetMesh& background, const PipelineOptions& options,
                                  const Run& run);

}  // namespace cleft
