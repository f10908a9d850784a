// One run of TetGen, which takes no memory but what is reserved before it starts.
#pragma once

#include "base/array.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// Delaunay tetrahedra of the points, as TetGen has them. Throws std::bad_alloc where memory will not do. The points
// go in by the order that they have (insertion_order.hpp). TetGen keeps its error bounds in global variables: one run
// at a time.
Array<Tet> run_tetgen(Array<Vec3>& points);

}  // namespace cleft
