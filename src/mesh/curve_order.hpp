// The order of points along a Hilbert curve: those that follow one another are near each other.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "base/vec.hpp"
#include "mesh/bounding_box.hpp"

#include <cstdint>

namespace cleft
{

// Where a point of the box is along the curve through it.
uint64_t place_on_curve(const Vec3& x, const BoundingBox& box);

// Whether one of two points at the same place of the curve comes first: by coordinates.
bool comes_first(const Vec3& x, const Vec3& y);

// Sorts indices of points along a Hilbert curve through the box of these points.
// Coordinates must be finite. The order follows from the coordinates alone; only points at one place keep the order in
// which they come.
void order_along_curve(const Array<Vec3>& points, Array<int32_t>& indices, const Run& run);

}  // namespace cleft
