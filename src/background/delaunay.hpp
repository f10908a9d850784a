// The one door to the Delaunay engine.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

#include <cstddef>

namespace cleft
{

// About seven tetrahedra a point, four numbers each, must stay below 2^31 in TetGen's arrays.
inline constexpr size_t kMostDelaunayPoints = 60'000'000;

// Delaunay tetrahedra of the points, positively oriented; every point is used. Refuses fewer than four points,
// non-finite coordinates and points all in one plane. Throws CLEFT_ERROR_UNSUPPORTED in a build without TetGen.
Array<Tet> delaunay(const Array<Vec3>& points, const Run& run);

}  // namespace cleft
