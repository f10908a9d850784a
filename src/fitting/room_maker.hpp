// Brings a point onto a place where the tetrahedra around do not leave it room, by moving the points around.
#pragma once

#include "base/array.hpp"
#include "improving/tie_constraint.hpp"
#include "remeshing/contraction.hpp"
#include "remeshing/point_moves.hpp"
#include "remeshing/smoothing.hpp"

namespace cleft
{

class RoomMaker
{
public:
    RoomMaker(LocalMesh& mesh, const Volume& volume) : mesh_(mesh), constraint_(volume) {}

    // Puts the point on its tie, and there to where the shapes let it stay: along its line, and with the points around
    // moving as well. No tetrahedron around gets worse than `least` (of shape_quality). If that cannot be, the mesh is
    // as it was. For several threads at once, `worker` being one of those that the mesh was made with, if no two have
    // one of add_touched_tets() in common. `unused`: slots that a contraction leaves, for LocalMesh::release().
    bool settle(int32_t v, const Vec3& on_tie, double least, int worker, Array<int32_t>& unused);
    // What settle() has moved, if it did.
    const Array<PointMove>& moved() const { return moves_.made; }
    // Adds all tetrahedra that settle() may read or change: those at the points that it may move, and at those whose
    // connections it may change. Some come more than once.
    void add_touched_tets(int32_t v, const Vec3& on_tie, Array<int32_t>& tets) const;

private:
    bool settle_here(int32_t v, const Vec3& on_tie, double least);
    bool settle_without_neighbour(int32_t v, const Vec3& on_tie, double least, int worker, Array<int32_t>& unused);
    bool is_beside(int32_t w, int32_t v, const Vec3& on_tie) const;
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
