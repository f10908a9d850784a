// Sizes that are greater along interfaces than across them.
#pragma once

#include "sizing/sizing_field.hpp"
#include "sizing/sizing_options.hpp"

namespace cleft
{

// As compute_sizing(), with a metric whose sizes at one place differ by options.anisotropy at most.
//   Across an interface the size is the isotropic one. Along it, in each principal direction, it is as much greater as
// the curvature allows: an edge h leaves the interface by h^2 k / 8, which is to be a tenth of the size across at most.
// Where several interfaces meet, each has its say, so that a triple line keeps two short directions. No size need be
// less than the voxel is long in its direction. Away from interfaces, sizes from features are greater by the ratio, and
// sizes that were asked for hold.
SizingField anisotropic_sizing(const Volume& volume, const SizingOptions& options, const Run& run);

}  // namespace cleft
