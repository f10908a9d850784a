// Darkens what lies between higher parts, as light from all sides would: corners and crevices become visible.
#pragma once

#include "base/run.hpp"
#include "io/render/canvas.hpp"

namespace cleft::io
{

// `pixels_per_unit`: of the depths of the canvas.
void darken_creases(double pixels_per_unit, const Run& run, Canvas& canvas);

}  // namespace cleft::io
