// The Delaunay engine of Cleft's own: bricks of points side by side.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

#include <cstdint>

namespace cleft
{

// A brick of so many takes up to 30 MB of a thread's memory. Smaller ones have more neighbours to take in for each of
// their points, larger ones leave more threads without work at the end.
inline constexpr int64_t kPointsInBrick = 50'000;

// Delaunay tetrahedra of different points with coordinates in [-2, 2], canonical and grouped by their least points.
// They follow from the points and their numbers alone: where more than four lie on a sphere, the numbers decide.
//   `first_tet`: four points that are not in one plane. `points_in_brick` changes time and memory, and no tetrahedron.
// Throws TwoAtOnePlace where two points are the same.
Array<Tet> brick_delaunay(const Array<Vec3>& points, const Tet& first_tet, int64_t points_in_brick, const Run& run);

}  // namespace cleft
