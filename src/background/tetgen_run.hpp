// One run of TetGen, which takes no memory but what is reserved before it starts.
#pragma once

#include "mesh/tet_mesh.hpp"

#include <vector>

namespace cleft
{

// Delaunay tetrahedra of the points, as TetGen has them. Throws std::bad_alloc where memory will not do. The points
// go in by the order that they have (insertion_order.hpp). TetGen keeps its error bounds in global variables: one run
// at a time.
std::vector<Tet> run_tetgen(std::vector<Vec3>& points);

}  // namespace cleft
