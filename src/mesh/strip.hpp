// Taking tetrahedra and points out of a mesh.
#pragma once

#include "base/array.hpp"
#include "mesh/tet_mesh.hpp"

#include <functional>

namespace cleft
{

// Takes out the points that no tetrahedron has. The others keep their order.
void drop_unused_points(Array<Vec3>& points, Array<Tet>& tets);

// Keeps the tetrahedra of the regions that keeps(region) is true for, and their points.
// `regions` has one entry per tetrahedron. The order stays, so a stripped mesh is the same bytes on every machine.
void strip(Array<Vec3>& points, Array<Tet>& tets, Array<int32_t>& regions,
           const std::function<bool(int32_t region)>& keeps);

}  // namespace cleft
