// Moves of points that can be taken back. One object is used again and again, so that its memory is kept.
#pragma once

#include "remeshing/local_mesh.hpp"

namespace cleft
{

struct PointMove {
    int32_t point;
    Vec3 from;
};

struct PointMoves {
    Array<PointMove> made;  // a point that has moved twice is in it twice

    void clear() { made.clear(); }
    void apply(LocalMesh& mesh, int32_t v, const Vec3& to)
    {
        made.push_back({v, mesh.point(v)});
        mesh.move(v, to);
    }
    // As long as the tetrahedra at the points are those of the moves. Backwards, because a point may have moved twice.
    void undo(LocalMesh& mesh)
    {
        for (; !made.empty(); made.pop_back())
            mesh.move(made.back().point, made.back().from);
    }
};

}  // namespace cleft
