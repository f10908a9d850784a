// Numbers that are equal up to rounding. (CMocka's assert_float_equal turns its arguments into floats.)
#pragma once

#include <cmath>

namespace cleft_test
{

inline bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

}  // namespace cleft_test
