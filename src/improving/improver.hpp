// The local search of improving: for each bad tetrahedron, worst first, every operation that may help.
#pragma once

#include "improving/compound_operations.hpp"
#include "improving/constrained_smoother.hpp"
#include "improving/search.hpp"
#include "remeshing/contraction.hpp"
#include "remeshing/worst_first.hpp"

namespace cleft
{

class Improver
{
public:
    // `target`: of angle_quality.
    Improver(LocalMesh& mesh, const Volume& volume, double target, const Run& run);

    // One search: passes until nothing changes any more, or as many as the search allows.
    void work(const Search& search, const Run& run);
    // The next searches aim higher, around what the last one left: they take other ways there.
    void aim_higher(double target);
    // Tetrahedra that the last search left below the target.
    size_t left() const { return bad_.size(); }
    const SearchCounts& counts() const { return counts_; }

private:
    void smooth_all(const Run& run);
    bool improve_tet(int32_t t);
    bool smooth_corners(int32_t t);
    bool change_connections(int32_t t);
    bool split(int32_t t, int corner_a, int corner_b);

    double target_;
    LocalMesh& mesh_;
    const Volume& volume_;
    // Kept from the start, so that points without a tie cannot wander off over many passes.
    Array<Vec3> home_;  // of each point: where cleaving, or the split that made it, put it
    ConstrainedSmoother smoother_;
    WorstFirst bad_;
    CompoundOperations compound_;
    Search search_{};
    bool started_ = false;
    size_t attempts_left_ = 0;  // in a pass
    Cavity cavity_;
    Contraction contraction_;
    SearchCounts counts_;
};

}  // namespace cleft
