// The tetrahedra of one brick of points.
#pragma once

#include "delaunay/kernel.hpp"
#include "delaunay/known_room.hpp"
#include "delaunay/point_tree.hpp"

namespace cleft
{

// What a thread keeps from brick to brick.
struct BrickWork {
    DelaunayKernel kernel;
    Array<int32_t> order, waiting;
    KnownRoom room;
};

// Those tetrahedra of the Delaunay mesh of all points whose least-numbered point is in the brick, made canonical.
//   The kernel gets the points of the brick and some near it. Then each cell at a point of the brick is certified: no
// point of the whole set is inside its sphere, or beyond its face on the hull. Where one is, it goes in too. Lemma: a
// certified real cell is one of the whole mesh; where all cells around a point are certified, they fill its surrounding
// like those of the whole mesh, so they are these.
//   `first_tet`: the positions of four points that are not in one plane.
Array<Tet> brick_tets(const PointTree& tree, int64_t brick, const FixedArray<int64_t, 4>& first_tet, BrickWork& work,
                      const Run& run);

}  // namespace cleft
