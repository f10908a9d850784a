// How many tetrahedra a mesh will have, before it is made.
#pragma once

#include "pipeline/pipeline.hpp"

namespace cleft
{

struct ExpectedMesh {
    double background_tets = 0;
    double cleaved_tets = 0;
    double whole_tets = 0;  // of the finished mesh before labels are left out
    double kept_tets = 0;
    bool is_rough = false;  // edges are long against the parts, so that the numbers may be far off
};

// Of the sizes as they are, whatever options.tets says.
ExpectedMesh expected_mesh(const Volume& volume, const SizingField& field, const PipelineOptions& options,
                           const Run& run);
// Of a background that is there.
ExpectedMesh expected_mesh(const Volume& volume, const TetMesh& background, const PipelineOptions& options,
                           const Run& run);

}  // namespace cleft
