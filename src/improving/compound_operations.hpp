// Operations that make a bad tetrahedron better together with the moves of points that follow. An operation may make
// things worse at first; then the points around are smoothed, and all is taken back if the worst tetrahedron has not
// become better by it. That is expensive, so for the few that nothing else could help.
#pragma once

#include "base/array.hpp"
#include "improving/constrained_smoother.hpp"
#include "improving/search.hpp"
#include "remeshing/contraction.hpp"
#include "remeshing/point_moves.hpp"
#include "remeshing/worst_first.hpp"

#include <array>
#include <set>

namespace cleft
{

class CompoundOperations
{
public:
    // `home`: see TieConstraint; it grows with the points of the mesh. `bad`: where the search lists what has changed.
    CompoundOperations(LocalMesh& mesh, const Volume& volume, Array<Vec3>& home, WorstFirst& bad)
        : mesh_(mesh), home_(home), smoother_(mesh, volume, home), bad_(bad)
    {
    }

    // Tries all of them for a tetrahedron, until one helps. `target`: of shape_quality.
    // If none helps, the mesh has its old shapes again. Tetrahedra may have other numbers, and points without
    // tetrahedra may be left.
    bool improve(int32_t t, const Search& search, double target);
    // By the one that helped.
    int64_t points_moved() const { return moves_.made.count(); }
    // See Smoother.
    int64_t places() const { return smoother_.places(); }

private:
    bool improve_at(const Tet& place, const Tet& bad, double before);
    void accept();
    int32_t find(const Tet& corners) const;
    Array<Tet> tets_around(const Tet& corners) const;
    bool attempt(int32_t t, int operation);
    bool apply_if(bool found);
    bool split_in_middle(int32_t t, int corner_a, int corner_b);
    bool smooth_all(const Tet& bad, double before);
    bool pays(const Tet& bad, double wanted);
    void smooth_and_note(int32_t t);
    bool is_smoothed(int32_t v);
    void disturb_around(int32_t v);
    void take_back();

    LocalMesh& mesh_;
    Array<Vec3>& home_;
    ConstrainedSmoother smoother_;
    WorstFirst& bad_;
    Search search_{};
    double target_ = 0;
    Cavity cavity_;
    Contraction contraction_;
    TetStar star_;
    PointMoves moves_;                      // of the attempt
    Array<uint64_t> smoothed_, disturbed_;  // by point: when it was smoothed, when something around it moved
    uint64_t clock_ = 0, attempt_began_ = 0;
    std::set<std::array<int32_t, 4>> tried_;  // for the bad tetrahedron, see subject_of
};

}  // namespace cleft
