// The numbering of a finished mesh.
#pragma once

#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// Renumbers points and tetrahedra along a Hilbert curve, for solvers; drops unused points.
// A matrix over points that are near each other in memory has its entries near the diagonal. The numbers before matter
// only for points at one place.
void order_spatially(LabelledMesh& mesh, const Run& run);

}  // namespace cleft
