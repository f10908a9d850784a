// One order of tetrahedra, whichever engine made them.
#pragma once

#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// Canonical tetrahedra, grouped by their least points: where the points are in a spatial order, so are the tetrahedra,
// and the stages that follow find in the cache what they need. A group is in one part. Frees the parts.
Array<Tet> grouped(Array<Array<Tet>>& parts, int64_t point_count, const Run& run);

}  // namespace cleft
