// Angles are given and reported in degrees.
#pragma once

#include <cmath>

namespace cleft
{

constexpr double kDegreesInRadian = 57.295779513082320877;

inline double sine_of(double degrees) { return std::sin(degrees * M_PI / 180); }

}  // namespace cleft
