// The order in which an incremental Delaunay engine shall insert points.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "base/vec.hpp"

#include <cstdint>

namespace cleft
{

inline constexpr int kInsertionRounds = 9;  // 8^9 are more points than there can be

// The round in which point `index` goes in: the last, 0, with a probability of 7/8, else the one before with 7/8, and
// so on. A hash of the index alone: the order does not depend on threads, nor on what the program draws.
int insertion_round(uint64_t index);

// Rounds of random points, each about eight times as many as the one before it, and each along a Hilbert curve: Amenta,
// Choi and Rote, "Incremental constructions con BRIO" (2003). Random enough for the expected number of changes, ordered
// enough that each point is found near the one before it. The same points give the same order.
Array<int32_t> insertion_order(const Array<Vec3>& points, const Run& run);

}  // namespace cleft
