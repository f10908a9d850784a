// Random metrics: wanted lengths that depend on the direction, for one of some seeds.
#pragma once

#include "storm/random_case.hpp"

#include <cstdint>

namespace storm
{

// One seed in twelve has a metric. The seed alone decides, so the other seeds keep their cases.
bool has_metric(uint64_t seed);

// Gives a case a metric in the place of its sizes. `least` is its least spacing.
void set_metric(Case& made, uint64_t seed, double least);

}  // namespace storm
