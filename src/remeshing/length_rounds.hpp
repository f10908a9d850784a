// Passes over the long edges of a mesh, and over the short ones.
#pragma once

#include "base/run.hpp"
#include "remeshing/length_changes.hpp"

namespace cleft
{

// Of a mesh that is measured. Each pass takes the tetrahedra with the longest (shortest) edges first. The same bytes
// for any number of threads.
void split_long_edges(LocalMesh& mesh, const LengthGoal& goal, int passes, const Run& run);
void contract_short_edges(LocalMesh& mesh, const LengthGoal& goal, int passes, const Run& run);

}  // namespace cleft
