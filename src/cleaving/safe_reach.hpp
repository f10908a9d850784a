// How far a vertex may snap under the paper's rule.
#pragma once

#include "cleaving/star.hpp"

namespace cleft
{

// Half, as in the paper: then the balls around two vertices do not overlap. A larger reach would let both ends of an
// edge claim its cut.
inline constexpr double kSnapReach = 0.5;  // how far a cut may be to be snapped to, in shortest edges at the vertex

// By edge, from its lower and its upper end.
using SafeReach = Array<FixedArray<double, 2>>;

// The paper's alpha, half of the shortest edge or altitude, does not see two opposite edges whose four ends move
// towards each other: half of their distance, too, must be left. On a body-centred cubic lattice that makes 0.25 of a
// long edge and 0.41 of a short one, the alphas of Labelle and Shewchuk. To be measured before anything moves.
SafeReach find_safe_reach(const Centres& c, const VertexTets& tets_of, const Run& run);

}  // namespace cleft
