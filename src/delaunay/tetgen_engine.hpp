// TetGen as the engine, with all checks around it that it does not make (decision 8).
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// As brick_delaunay(): canonical and grouped by their least points. Where points are the same, all but one of them have
// no tetrahedron. Throws CLEFT_ERROR_UNSUPPORTED in a build without TetGen.
Array<Tet> tetgen_delaunay(const Array<Vec3>& points, const Run& run);

}  // namespace cleft
