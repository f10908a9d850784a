// A body-centred cubic lattice: what its cells have in common wherever it is used.
#pragma once

#include <cmath>

namespace cleft
{

// Mean edge over the side of the cell: 6 edges a point have length 1, 8 have length sqrt(3) / 2.
inline const double kMeanEdge = (6 + 8 * std::sqrt(0.75)) / 14;

// Four tetrahedra around each of six faces, half of which belong to the cell behind; at a wall two in the cell.
inline constexpr double kTetsOfBccCell = 12;

}  // namespace cleft
