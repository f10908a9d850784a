// The volume of the voxels that a piece of a mesh covers: what the volumes of its labels are to be.
#pragma once

#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"
#include "volume/volume.hpp"

namespace cleft
{

// By material: of the voxels of which a place lies in the tetrahedra. Each such place lies in one tetrahedron of a
// whole mesh, so the volumes of all its pieces add up to those of the voxels. For functions, whose volumes nobody
// knows, there are none.
Array<double> volumes_inside(const Volume& volume, const LabelledMesh& mesh, const Run& run);

}  // namespace cleft
