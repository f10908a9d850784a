// Brings a point onto a place where the tetrahedra around do not leave it room, by moving the points around.
#pragma once

#include "base/array.hpp"
#include "improving/tie_constraint.hpp"
#include "remeshing/contraction.hpp"
#include "remeshing/point_moves.hpp"
#include "remeshing/smoothing.hpp"

namespace cleft
{

// Not for several threads on one mesh.
class RoomMaker
{
public:
    RoomMaker(LocalMesh& mesh, const Volume& volume) : mesh_(mesh), constraint_(volume) {}

    // Puts the point on its tie, and there to where the shapes let it stay: along its line, and with the points around
    // moving as well. No tetrahedron around gets worse than `least` (of shape_quality). If that cannot be, the mesh is
    // as it was, but tetrahedra may have other numbers.
    bool settle(int32_t v, const Vec3& on_tie, double least);

private:
    bool settle_here(int32_t v, const Vec3& on_tie, double least);
    bool settle_without_neighbour(int32_t v, const Vec3& on_tie, double least);
    Place climb(int32_t v, const Vec3& from, double least);
    bool make_room(int32_t v, double least);
    bool is_good(int32_t v, double least);
    Array<int32_t> points_around(int32_t v) const;

    LocalMesh& mesh_;
    TieConstraint constraint_;
    Smoother smoother_;
    TetStar star_;
    PointMoves moves_;
    Contraction contraction_;
    Cavity cavity_;
};

}  // namespace cleft
