// The values of a NIfTI file whose header scales them.
#pragma once

#include "io/image.hpp"

namespace cleft::io
{

// Do these change values? A slope that is 0 or not a number says that there is no scaling.
bool is_scaled(double slope, double intercept);
// Replaces each value v by slope * v + intercept, and notes it; nothing is done unless is_scaled(). The result is of
// int32 if all values are whole and fit, else of double.
void scale_values(double slope, double intercept, Image& image);

}  // namespace cleft::io
