// Taking tetrahedra and points out of a mesh.
#pragma once

#include "mesh/tet_mesh.hpp"

#include <functional>

namespace cleft
{

// Takes out the points that no tetrahedron has. The others keep their order.
void drop_unused_points(std::vector<Vec3>& points, std::vector<Tet>& tets);

// Keeps the tetrahedra of the regions that keeps(region) is true for, and their points.
void strip(std::vector<Vec3>& points, std::vector<Tet>& tets, std::vector<int32_t>& regions,
           const std::function<bool(int32_t region)>& keeps);

}  // namespace cleft
