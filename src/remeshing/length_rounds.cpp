// Lets tetrahedra with edges of bad lengths be visited as others visit those of bad shapes.
#include "remeshing/length_rounds.hpp"

#include "base/per_worker.hpp"
#include "remeshing/rounds.hpp"

namespace cleft
{

namespace
{

void change_lengths(LocalMesh& mesh, WorstFirst::Measure goodness, double target, const LengthGoal& goal, int passes,
                    void (LengthChanges::*find_change)(int32_t, Proposal&), const Run& run)
{
    WorstFirst list(std::move(goodness));
    list.collect_all(mesh, target, run);
    Rounds rounds(mesh, list);
    PerWorker<LengthChanges> finders(run, mesh, goal);
    const auto find = [&](int worker, int32_t t, int, Proposal& proposal) {
        (finders[worker].*find_change)(t, proposal);
        return 0;
    };
    const double share = 1.0 / passes;
    bool changed = true;
    for (int pass = 0; pass < passes && changed; ++pass) {
        changed = rounds.visit(
            0, list.size(), target, find, [](const Proposal&) {}, run, pass * share, share);
        list.collect_next(mesh, target);
    }
}

}  // namespace

void split_long_edges(LocalMesh& mesh, const LengthGoal& goal, int passes, const Run& run)
{
    change_lengths(
        mesh, [&](int32_t t) { return 1 / longest_edge(mesh, t); }, 1 / goal.longest, goal, passes,
        &LengthChanges::find_split, run);
}

void contract_short_edges(LocalMesh& mesh, const LengthGoal& goal, int passes, const Run& run)
{
    change_lengths(
        mesh, [&](int32_t t) { return shortest_edge(mesh, t); }, goal.shortest, goal, passes,
        &LengthChanges::find_contraction, run);
}

}  // namespace cleft
