// Four points that are not in one plane.
#pragma once

#include "mesh/tet_mesh.hpp"

#include <optional>

namespace cleft
{

// The first point, that farthest from it, that farthest from their line, and any point off their plane (exactly). Far
// corners make the first tetrahedron large. Nothing where all points are in one plane.
std::optional<Tet> widest_tet(const Array<Vec3>& points);

}  // namespace cleft
