// Whether points of different parts are at one place.
#pragma once

#include "base/vec.hpp"
#include "parts/exchange.hpp"

namespace cleft
{

// Of the first `count` points of each rank. All ranks hear the same.
bool has_repeated_places(const Array<Vec3>& points, int64_t count, Exchange& exchange);

}  // namespace cleft
