// Moves points of a mesh as if each edge were a spring of length one in the metric.
#pragma once

#include "remeshing/local_mesh.hpp"

namespace cleft
{

// One sweep over all points but those of interfaces, within the planes of the hull. No tetrahedron gets worse than
// `floor` (of shape_quality) or than the worst around the point already is.
void relax_springs(LocalMesh& mesh, double floor, const Run& run);

}  // namespace cleft
