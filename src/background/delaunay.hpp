// The one door to the Delaunay engine.
#pragma once

#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

#include <vector>

namespace cleft
{

// Delaunay tetrahedra of the points, positively oriented; every point is used. Refuses fewer than four points,
// non-finite coordinates and points all in one plane. Throws CLEFT_ERROR_UNSUPPORTED in a build without TetGen.
std::vector<Tet> delaunay(const std::vector<Vec3>& points, const Run& run);

}  // namespace cleft
