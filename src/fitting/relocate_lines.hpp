// Points where three materials or more meet belong on the tie of all of them.
#pragma once

#include "base/array.hpp"
#include "fitting/meetings.hpp"
#include "volume/volume.hpp"

namespace cleft
{

struct LinePoints {
    int64_t off = 0;             // how many are not on their tie yet
    Array<int32_t> without_tie;  // near enough
};

// Cleaving leaves triple points at the mean of the cuts around them, and improving lets the points of bad tetrahedra
// leave the tie by a little: each such point moves back to it, or as much of the way as leaves the tetrahedra around no
// worse than `floor` (of shape_quality) or than the worst of them already is.
//   The functions of label maps are flat some voxels away from a label, and tell no way to the tie there. With
// `looks_around`, such a point looks for a place around it from which they do.
LinePoints relocate_lines(LocalMesh& mesh, const Volume& volume, double floor, const Meetings& meetings, const Run& run,
                          bool looks_around = false);

}  // namespace cleft
