// The quality of a mesh that ranks share.
#pragma once

#include "mesh/quality.hpp"
#include "parts/mesh_part.hpp"

namespace cleft
{

// Of the whole mesh, the same on all ranks. Only sums depend on the number of ranks, in their last digits.
Quality part_quality(const MeshPart& part, Exchange& exchange, const Run& run);
// Of the tetrahedra that the part owns.
Quality own_quality(const MeshPart& part, const Run& run);

}  // namespace cleft
