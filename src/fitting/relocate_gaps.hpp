// Interfaces that bridge a gap too thin for the tetrahedra.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "remeshing/local_mesh.hpp"
#include "volume/volume.hpp"

namespace cleft
{

// Where two balls all but touch, the mesh joins them: they meet in a patch halfway across the gap, and along its rim
// three materials meet that tie nowhere near. Such points belong on a true interface, on one side of the gap, as far as
// the tetrahedra around get no worse than `floor` (of shape_quality) or than the worst of them already is.
// `without_tie`: points of three materials or more without a tie. Returns these and the
// points of the patch, which it finds from them.
Array<int32_t> relocate_gaps(LocalMesh& mesh, const Volume& volume, double floor, Array<int32_t> without_tie,
                             const Run& run);

}  // namespace cleft
