// Edges of interfaces that are too long for the curvature there.
#pragma once

#include "fitting/meetings.hpp"
#include "volume/volume.hpp"

#include <cstdint>

namespace cleft
{

// Whether few edges are further off: sizes that follow the error leave some. Many are in a mesh whose sizes were made
// for something else.
bool are_sizes_for(double error, const LocalMesh& mesh, const Volume& volume, const Meetings& meetings, const Run& run);

// Puts a point of the interface into each of its edges whose middle is further than `error` from it, or a point halfway
// there, if all tetrahedra around are better than `floor` (of shape_quality) then. Single edges of a background are up
// to 2.3 times as long as the size asks for, and their middles five times as far off. Returns the number of points.
int64_t split_far_edges(LocalMesh& mesh, const Volume& volume, double error, double floor, const Run& run);

}  // namespace cleft
