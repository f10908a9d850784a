// Snapping: vertices next to an interface, a triple line or a quadruple point move onto it (paper, section 3.1, the
// violation of alpha), which takes away the cuts that would leave thin pieces.
#pragma once

#include "cleaving/centres.hpp"
#include "cleaving/cleave.hpp"

namespace cleft
{

struct SnapCounts {
    int64_t moved = 0;   // vertices that moved onto a tie
    int64_t stayed = 0;  // vertices that took materials over where they are
};

// Vertices of the hull stay in their box face; those of a hull face across no axis stay where they are.
// Vertices that are held stay as they are. Changes points, materials, cuts and fans of `c` in place.
SnapCounts snap_vertices(Centres& c, Snap rule, const Array<int32_t>& held, const Run& run);

}  // namespace cleft
