// Edge split: puts a point into an edge.
#pragma once

#include "remeshing/cavity.hpp"

namespace cleft
{

// The axes along which a point put into the edge must not move: those of the hull that the edge lies in.
uint8_t frozen_on_edge(const LocalMesh& mesh, const EdgeRing& ring);

// Puts a point at x into the edge of the ring; each tetrahedron of the ring becomes two. The caller has made sure that
// they are positive. Returns the number of the new point.
int32_t split_edge(LocalMesh& mesh, const EdgeRing& ring, const Vec3& x, Cavity& cavity);

}  // namespace cleft
