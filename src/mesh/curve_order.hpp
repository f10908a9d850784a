// The order of points along a Hilbert curve: those that follow one another are near each other.
#pragma once

#include "base/run.hpp"
#include "base/vec.hpp"

#include <cstdint>
#include <vector>

namespace cleft
{

// Sorts indices of points along a Hilbert curve through the box of these points.
void order_along_curve(const std::vector<Vec3>& points, std::vector<int32_t>& indices, const Run& run);

}  // namespace cleft
