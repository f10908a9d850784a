// Sizes that keep triangles near their interface.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "sizing/compute.hpp"
#include "volume/volume.hpp"

namespace cleft
{

// The greatest sizes with which triangles stay within `error` of the interfaces, and edges of the lines where three
// materials meet: at the voxels that have a point of one.
//   An edge h of a curve of curvature k is h^2 k / 8 away from it in its middle: within an error e if h <= sqrt(8 e /
//   k).
// Triangles are further off than their edges, and edges are not all as long as the size asks for. So the size is a
// share of that length, which was measured on balls, tori and halves of a ball.
Array<SizeLimit> sizes_for_error(const Volume& volume, double error, const Run& run);

}  // namespace cleft
