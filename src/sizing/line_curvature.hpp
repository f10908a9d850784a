// How much the lines of a volume are curved where three materials meet.
#pragma once

#include "sizing/surface_curvature.hpp"

namespace cleft
{

// At each point of find_line_points(), the curvature of the line: that of the parabola that fits the points of the same
// line in a window.
Array<CurvedPoint> line_curvatures(const Volume& volume, const Run& run);

}  // namespace cleft
