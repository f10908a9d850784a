// The search for points of the whole set that a cell of one brick must not have.
#pragma once

#include "delaunay/kernel.hpp"
#include "delaunay/point_tree.hpp"

namespace cleft
{

// A point, none of the brick's own, inside the sphere of a real cell, that nearest to its centre; or beyond the face of
// a ghost, that nearest to its first corner. Returns its position in the tree; -1: there is none.
//   Points in the plane of a ghost's face are not looked for: they are inside the sphere of the cell behind it too.
int64_t find_intruder(const PointTree& tree, int64_t brick, const DelaunayKernel& kernel, const Cell& cell);

}  // namespace cleft
