// How far below the interface its triangles lie.
#pragma once

#include "fitting/interface_triangles.hpp"
#include "volume/volume.hpp"

namespace cleft
{

// Sets the heights. Points in `without_tie` are not where their materials tie: there, heights are above the triangle
// that the interface has under it.
void find_heights(const LocalMesh& mesh, const Volume& volume, const std::vector<int32_t>& without_tie,
                  std::vector<InterfaceTriangle>& triangles, const Run& run);

}  // namespace cleft
