// Which vertices snapping visits, and in which order.
#pragma once

#include "base/array.hpp"
#include "cleaving/snap_visit.hpp"

namespace cleft
{

// Touched vertices with a cut within `reach` times their shortest edge. The nearer a cut is, the sooner its
// vertex comes, in a few steps; within a step vertices go by their numbers, which are close where vertices are close.
Array<int32_t> vertices_to_visit(const SnapState& state, double reach, const Run& run);

}  // namespace cleft
