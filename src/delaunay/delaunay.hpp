// The one door to the Delaunay engines.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

#include <cstddef>

namespace cleft
{

// About seven tetrahedra a point, four numbers each, must stay below 2^31 in TetGen's arrays.
inline constexpr size_t kMostDelaunayPoints = 60'000'000;

/* <choice> Made by tools/generate.py from src/capi/options.toml. */
enum class DelaunayEngine { cleft, tetgen };
inline constexpr size_t kDelaunayEngineCount = 2;
/* </choice> */

// Delaunay tetrahedra of the points, positively oriented; every point is used. Refuses fewer than four points,
// non-finite coordinates, points all in one plane and points at one place. TetGen is refused with
// CLEFT_ERROR_UNSUPPORTED in a build without it.
//   Where no five points are on a sphere with no other point inside, both engines give the same bytes.
Array<Tet> delaunay(const Array<Vec3>& points, DelaunayEngine engine, const Run& run);

}  // namespace cleft
