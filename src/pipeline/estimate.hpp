// What a mesh will come to before it is made: tetrahedra and memory.
#pragma once

#include "pipeline/pipeline.hpp"

namespace cleft
{

struct Estimate {
    double background_tets = 0;
    double whole_tets = 0;  // of the finished mesh before labels are left out
    double tets = 0;        // of the materials that are kept
    double peak_bytes = 0;  // of the process that makes it, no less
    // There may be fewer: labels have so few points each that most of the cuts may have to stay.
    bool is_bound = false;
};

// For a sizing field, of which no mesh is made.
Estimate estimate_from_sizing(const Volume& volume, ScaledSizing sizing, const PipelineOptions& options,
                              const Run& run);
// For a background that is there.
Estimate estimate_from_background(const Volume& volume, const TetMesh& background, const PipelineOptions& options,
                                  const Run& run);

}  // namespace cleft
