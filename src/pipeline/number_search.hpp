// Meshing at other sizes until the number of tetrahedra is the wanted one.
#pragma once

#include "pipeline/pipeline.hpp"

namespace cleft
{

// Scales a sizing field so that about options.tets tetrahedra of the kept materials are to be expected of the finished
// mesh; 0: leaves it.
void fit_to_number(SizingField& field, const Volume& volume, const PipelineOptions& options, const Run& run);

// The mesh at the scale of the sizing field that gives options.tets tetrahedra of the kept materials, without the
// finishing; the field is left at that scale. A field whose scale was found for that number is tried as it is. Warns if
// the number is not met.
LabelledMesh mesh_of_number(const Volume& volume, SizingField& field, const PipelineOptions& options, const Run& run);

}  // namespace cleft
