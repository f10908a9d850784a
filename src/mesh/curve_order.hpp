// The order of points along a Hilbert curve: those that follow one another are near each other.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "base/vec.hpp"

#include <cstdint>

namespace cleft
{

// Sorts indices of points along a Hilbert curve through the box of these points.
void order_along_curve(const Array<Vec3>& points, Array<int32_t>& indices, const Run& run);

}  // namespace cleft
