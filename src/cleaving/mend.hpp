// Where cleaving left an interface of two materials pinched, it is mended: a few tetrahedra go from one to the other.
//
// Cleaving without snapping makes surfaces. A vertex that snaps between two sheets of one interface pulls both onto
// itself, which can be the only way to good angles (see snap.cpp), and where three materials are near, nothing watches.
// Then four sectors A B A B of two materials meet at an edge, or two pieces of one touch in a point.
//
// A change gives to B some tetrahedra of A: one, a sector around a pinched edge, or a piece at a pinched point. It is
// made only if fewer pinched edges and points are left around, so that mending ends. Among those that do no harm, which
// cut no piece of A and join none of B, the change of least volume is taken; then those that do; and, if one change
// alone does not help, two.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// `points`: all where interfaces can be pinched; of each pinched edge one end does. No label loses its last
// tetrahedron. Notes cleaving.pinched (points that were), cleaving.mended (tetrahedra changed) and
// cleaving.left_pinched.
void mend_interfaces(LabelledMesh& mesh, const Array<int32_t>& points, const Run& run);

}  // namespace cleft
