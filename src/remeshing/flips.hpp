// Flips: changes of the connections between points that stay where they are. They are found here, and not made: true
// where `cavity` has one to apply.
#pragma once

#include "remeshing/cavity.hpp"

namespace cleft
{

// Edge removal: takes out the edge between two corners of t and fills its ring with the best of all triangulations
// (Klincsek's dynamic programming), if that makes the worst tetrahedron better (than `share` of its quality). Contains
// the 3-2 and 4-4 flips and, in a plane of the hull, the 2-2 flip. An edge in the interface of two materials is taken
// out too if the two interface triangles at it are flat within `bend` (the distance that the interface moves, in the
// frame of the metric).
bool find_edge_removal(const LocalMesh& mesh, int32_t t, int corner_a, int corner_b, double bend, Cavity& cavity,
                       double share = 1);

// The edges of a tetrahedron (numbers into kEdgeCorners), that of the greatest dihedral angle first: where the removal
// of an edge mends a tetrahedron, it is nearly always this one.
std::array<size_t, 6> most_obtuse_first(const LocalMesh& mesh, int32_t t);

// The 2-3 flip: takes out the face opposite `corner` of t and joins the two points at its sides, if that makes the
// worst tetrahedron better (than `share` of its quality).
// Faces of the hull and between materials are refused.
bool find_face_removal(const LocalMesh& mesh, int32_t t, int corner, Cavity& cavity, double share = 1);

}  // namespace cleft
