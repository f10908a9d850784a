// A change of a mesh that was found and is not made yet.
#pragma once

#include "remeshing/cavity.hpp"

namespace cleft
{

struct Proposal {
    enum class Kind : uint8_t { none, move, edge_removal, face_removal, contraction, split };

    Kind kind = Kind::none;
    Cavity cavity;       // of a move: old_tets are the tetrahedra at the point, and the rest is not used
    int32_t point = -1;  // that moves
    Vec3 place;          // of the point that moves or is new

    // To move the point in the middle of the star.
    void set_move(int32_t v, const Vec3& to, const Array<int32_t>& star)
    {
        kind = Kind::move;
        point = v;
        place = to;
        cavity.old_tets = star;
    }
    // The tetrahedra that are changed when it is made.
    const Array<int32_t>& changed() const { return kind == Kind::move ? cavity.old_tets : cavity.created; }

    void make(LocalMesh& mesh);
    // make() in three steps. The second may be taken by several threads at once for proposals whose old tetrahedra have
    // no point in common. The other two are for one thread.
    void begin(LocalMesh& mesh);
    void make(LocalMesh& mesh, int worker);
    void end(LocalMesh& mesh);
};

}  // namespace cleft
