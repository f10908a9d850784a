// What a volume may be. Beyond these limits the arithmetic of the stages no longer tells points apart, so that what
// lies beyond is refused where a volume is made. The header of the C interface states them.
#pragma once

#include "volume/frame.hpp"

namespace cleft
{

// World units between the centres of neighbouring voxels, and between their planes where the affine shears.
inline constexpr double kLeastSpacing = 1e-15, kGreatestSpacing = 1e15;
// The greatest spacing over the least.
inline constexpr double kGreatestStretch = 1000;
// The greatest world coordinate of the box over the least distance between planes of voxels.
inline constexpr double kGreatestDistance = 1e14;
// Wanted edge lengths; features and options ask for far less and far more than a box can use.
inline constexpr double kLeastSize = 1e-30, kGreatestSize = 1e30;

// False for NaN, too.
inline bool is_size(double h) { return h >= kLeastSize && h <= kGreatestSize; }

// An indicator function is followed up to this magnitude. What is beyond stands for "far away", as sentinels do, and
// counts as so many times the greatest magnitude that is within.
inline constexpr double kGreatestValue = 1e30;
inline constexpr double kFarValue = 2;

// Throws an Error that names the value which is beyond its limit.
void check_limits(const Frame& frame);

}  // namespace cleft
