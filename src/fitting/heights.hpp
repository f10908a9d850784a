// How far below the interface its triangles lie.
#pragma once

#include "base/array.hpp"
#include "fitting/interface_triangles.hpp"
#include "volume/volume.hpp"

namespace cleft
{

// Sets the heights. Points in `without_tie` are not where their materials tie: there, heights are above the triangle
// that the interface has under it.
// A triangle with no interface within reach gets the height 0, and stays where it is. Lengths are world units.
void find_heights(const LocalMesh& mesh, const Volume& volume, const Array<int32_t>& without_tie,
                  Array<InterfaceTriangle>& triangles, const Run& run);

}  // namespace cleft
