// A pass of a local search on all threads, with the same result for any number of them: changes are found side by side
// on one mesh, and those that have no point in common are made side by side (deterministic reservations: Blelloch,
// Fineman, Gibbons, Shun 2012).
#pragma once

#include "remeshing/proposal.hpp"
#include "remeshing/worst_first.hpp"

#include <functional>

namespace cleft
{

class Rounds
{
public:
    // Looks for a change that helps a tetrahedron, with operations from the `step`-th on. Returns the step to go on
    // with if the change leaves the tetrahedron in the mesh (if it is a move). Called on several threads.
    using Find = std::function<int(int worker, int32_t t, int step, Proposal& proposal)>;
    // Called for each change that was made, in order.
    using Made = std::function<void(const Proposal& proposal)>;

    Rounds(LocalMesh& mesh, WorstFirst& bad) : mesh_(mesh), bad_(bad) {}

    // Visits the tetrahedra of the list from number `begin` to before `end`, which are below the target, and gives all
    // of them back. True if something changed. Progress goes from `done` to `done` + `share`.
    bool visit(size_t begin, size_t end, double target, const Find& find, const Made& made, const Run& run, double done,
               double share);
    // Tetrahedra for which something was looked for, each time that one was visited.
    int64_t tried() const { return tried_; }

private:
    struct Visit {
        size_t item;  // number in the list
        int step = 0;
        bool moved = false;  // a corner, earlier in this pass
    };

    void find_all(double target, const Find& find, const Run& run);
    void claim(const Proposal& proposal, uint32_t rank);
    void check_claims(const Run& run);
    bool has_all(const Proposal& proposal, uint32_t rank) const;
    void choose();
    void make_all(const Made& made, const Run& run);

    LocalMesh& mesh_;
    WorstFirst& bad_;
    Array<Visit> visits_;         // of the round
    Array<Proposal> proposals_;   // by visit
    Array<int> next_step_;        // by visit
    Array<uint8_t> has_all_;      // by visit: all that it claimed
    Array<size_t> chosen_;        // visits whose changes are made
    Array<Visit> waiting_;        // for the next round
    Array<uint32_t> claimed_by_;  // by point: the least rank of a proposal that would change something at it
    int64_t tried_ = 0;
    uint32_t ranks_left_ = 0;  // ranks of a round are less than those of all earlier ones
};

}  // namespace cleft
