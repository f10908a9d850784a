// The local search of improving: for each bad tetrahedron, worst first, every operation that may help.
#pragma once

#include "base/per_worker.hpp"
#include "improving/change_finder.hpp"
#include "improving/compound_operations.hpp"
#include "remeshing/rounds.hpp"

namespace cleft
{

class Improver
{
public:
    // `target`: of shape_quality.
    Improver(LocalMesh& mesh, const Volume& volume, double target, const Run& run);

    // One search: passes until nothing changes any more, or as many as the search allows.
    void work(const Search& search, const Run& run);
    // The next searches aim higher, around what the last one left: they take other ways there.
    void aim_higher(double target);
    // Tetrahedra that the last search left below the target.
    size_t left() const { return bad_.size(); }
    const SearchCounts& counts() const { return counts_; }

private:
    bool pass(size_t most, const Run& run, double done, double share);
    bool improve_tet(int32_t t);
    void count(const Proposal& proposal);
    void count_places();

    double target_;
    LocalMesh& mesh_;
    // Kept from the start, so that points without a tie cannot wander off over many passes.
    Array<Vec3> home_;  // of each point: where cleaving, or the split that made it, put it
    PerWorker<ChangeFinder> finders_;
    WorstFirst bad_;
    Rounds rounds_;
    CompoundOperations compound_;
    Search search_{};
    bool started_ = false;
    int32_t most_tets_;         // of all searches
    size_t attempts_left_ = 0;  // in a pass
    Proposal proposal_;
    SearchCounts counts_;
};

}  // namespace cleft
