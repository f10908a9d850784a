// Points where three or four materials meet belong on the tie of all of them.
#pragma once

#include "base/run.hpp"
#include "mesh/local_mesh.hpp"
#include "volume/volume.hpp"

namespace cleft
{

// Cleaving leaves triple points at the mean of the cuts around them, and improving lets the points of bad tetrahedra
// leave the tie by a little: each such point moves back to it, or as much of the way as leaves the tetrahedra around no
// worse than `floor` (of angle_quality) or than the worst of them already is. Returns how
// many are not there yet.
int64_t settle_lines(LocalMesh& mesh, const Volume& volume, double floor, const Run& run);

}  // namespace cleft
