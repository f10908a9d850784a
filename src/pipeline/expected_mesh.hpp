// How many tetrahedra a mesh will have, before it is made.
#pragma once

#include "base/array.hpp"
#include "pipeline/pipeline.hpp"

namespace cleft
{

struct ExpectedMesh {
    double background = 0;
    double whole = 0;  // of the finished mesh before labels are left out
    double kept = 0;   // of the materials that are kept
    // There may be fewer: labels have so few points each that most of the cuts may have to stay.
    bool is_bound = false;
};

// Of the sizes as they are, whatever options.tets says.
ExpectedMesh expected_mesh(const Volume& volume, const SizingField& field, const PipelineOptions& options,
                           const Run& run);
// Of a background that is there. keep[material] != 0, all if it is empty.
ExpectedMesh expected_mesh(const Volume& volume, const TetMesh& background, const Array<char>& keep, const Run& run);

}  // namespace cleft
