// Which points can be corners of a face of the mesh's surface: of the hull, or between two regions.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// By point: 1 if each face at it belongs to two tetrahedra, as inside a mesh; also if there is none.
Array<uint8_t> points_inside(const Array<Tet>& tets, size_t point_count, const Run& run);

// By point: 1 if it is a corner of a face of the hull or of one between two regions. Tetrahedra with a bad index are
// left out.
// The reverse is not true: a face inside a region may have three corners on the surface.
Array<uint8_t> surface_points(const RegionMesh& mesh, const Run& run);

}  // namespace cleft
