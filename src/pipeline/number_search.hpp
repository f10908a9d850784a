// Meshing at other sizes until the number of tetrahedra is the wanted one.
#pragma once

#include "pipeline/expected_mesh.hpp"
#include "pipeline/pipeline.hpp"

namespace cleft
{

// Scales a sizing field so that about options.tets tetrahedra of the kept materials are to be expected of the finished
// mesh; 0: leaves it.
void scale_by_estimate(ScaledSizing& sizing, const Volume& volume, const PipelineOptions& options, const Run& run);

// How many times what the scaled field is expected to give the mesh has in the end: the search goes on to the number,
// or to the limit of the whole mesh.
double factor_of_search(const ExpectedMesh& expected, const PipelineOptions& options);

// The mesh at the scale of the sizing field that gives options.tets tetrahedra of the kept materials, without the
// finishing; it is left at that scale. One whose scale was found for that number is tried as it is. Warns if
// the number is not met.
LabelledMesh mesh_of_number(const Volume& volume, ScaledSizing& sizing, const PipelineOptions& options, const Run& run);

}  // namespace cleft
