// Edge split: puts a point into an edge.
#pragma once

#include "remeshing/cavity.hpp"

namespace cleft
{

// The axes along which a point put into the edge must not move: those of the hull that the edge lies in.
uint8_t frozen_on_edge(const LocalMesh& mesh, const EdgeRing& ring);

// To put a point into the edge of cavity.ring; each tetrahedron of the ring becomes two, with kNewPoint as a corner.
// The caller has made sure that they are positive.
void find_split(const LocalMesh& mesh, Cavity& cavity);
// Makes the split that was found, with the new point at x. Returns its number.
int32_t apply_split(LocalMesh& mesh, const Vec3& x, Cavity& cavity);

}  // namespace cleft
