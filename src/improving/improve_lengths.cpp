// Contracts short edges and lets springs take up the room.
#include "improving/improve_lengths.hpp"

#include "base/degrees.hpp"
#include "base/stage.hpp"
#include "remeshing/length_rounds.hpp"
#include "remeshing/springs.hpp"

#include <cmath>

namespace cleft
{

void improve_lengths(LocalMesh& mesh, double least_angle, const Run& run)
{
    // Passes over short edges, and sweeps of springs. A tilted plane through layers of 100 to 1 has 89 % of its edges
    // in range without any, 94 % after the first and 95 % after both.
    constexpr int kPasses = 2, kSweeps = 2;
    const LengthGoal goal{kShortest, HUGE_VAL, kLongestMade, sine_of(least_angle)};
    Stage stage(run, "lengths", {{"improving: lengths", 3}, {nullptr, 1}});
    contract_short_edges(mesh, goal, kPasses, stage.next());
    Steps sweeps(stage.next(), Array<Step>(kSweeps, {nullptr, 1}));
    for (int sweep = 0; sweep < kSweeps; ++sweep)
        relax_springs(mesh, goal.enough, sweeps.next());
}

}  // namespace cleft
