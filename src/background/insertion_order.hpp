// The order in which an incremental Delaunay engine shall insert points.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "base/vec.hpp"

#include <cstdint>

namespace cleft
{

// Rounds of random points, each about eight times as many as the one before it, and each along a Hilbert curve: Amenta,
// Choi and Rote, "Incremental constructions con BRIO" (2003). Random enough for the expected number of changes, ordered
// enough that each point is found near the one before it. The same points give the same order.
Array<int32_t> insertion_order(const Array<Vec3>& points, const Run& run);

}  // namespace cleft
