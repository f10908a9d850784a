// What a volume may be. Beyond these limits the arithmetic of the stages no longer tells points apart, so that what
// lies beyond is refused where a volume is made. The header of the C interface states them.
#pragma once

#include "volume/frame.hpp"

namespace cleft
{

// World units between the centres of neighbouring voxels, and between their planes where the affine shears.
// Cubes of these lengths, and quotients of such cubes, are far within the range of a double.
inline constexpr double kLeastSpacing = 1e-15, kGreatestSpacing = 1e15;
// The greatest spacing over the least.
// Kernels work in voxels, sizes and distances in world units, and the two agree less the greater this is. Random
// volumes are stretched up to here in tests, and beyond to see that they are refused (docs/reliability.md).
inline constexpr double kGreatestStretch = 1000;
// Up to this stretch the sizes follow the thickness of a plate whatever it costs. Beyond it thin volumes may have no
// good tetrahedra, and the warning on missed angles names the stretch.
inline constexpr double kUsualStretch = 6;
// The greatest world coordinate of the box over the least distance between planes of voxels.
// A double then has at least 45 steps between two planes; at ten times the distance it could have as few as four.
inline constexpr double kGreatestDistance = 1e14;
// Wanted edge lengths; features and options ask for far less and far more than a box can use.
// A sizing field keeps them as floats, whose normal numbers end at 1e-38 and 3e38. The scaling of a field has the rest.
inline constexpr double kLeastSize = 1e-30, kGreatestSize = 1e30;

// False for NaN, too.
inline bool is_size(double h) { return h >= kLeastSize && h <= kGreatestSize; }

// An indicator function is followed up to this magnitude. What is beyond stands for "far away", as sentinels do, and
// counts as so many times the greatest magnitude that is within.
// The float that stores the value, doubled by kFarValue, is finite, and so are the products of doubles that use it.
inline constexpr double kGreatestValue = 1e30;
// With 2, a band of distances among sentinels comes out whole: the interpolation does not cross zero beside it.
inline constexpr double kFarValue = 2;

// Throws an Error that names the value which is beyond its limit.
void check_limits(const Frame& frame);

}  // namespace cleft
