// The values of a NIfTI file whose header scales them.
#pragma once

#include "io/image.hpp"

namespace cleft::io
{

// Replaces each value v by slope * v + intercept, and notes it; nothing is done where the slope is 0 or not a number,
// which say that there is no scaling. The result is of int32 if all values are whole and fit, else of double.
void scale_values(double slope, double intercept, Image& image);

}  // namespace cleft::io
