// Which vertices snapping visits, and in which order.
#pragma once

#include "base/array.hpp"
#include "cleaving/centres.hpp"

namespace cleft
{

// Vertices marked in `touched` with a cut within `reach` times their shortest edge. The nearer a cut is, the sooner its
// vertex comes, in a few steps; within a step vertices go by their numbers, which are close where vertices are close.
Array<int32_t> vertices_to_visit(const Centres& c, double reach, const Array<uint8_t>& touched, const Run& run);

}  // namespace cleft
