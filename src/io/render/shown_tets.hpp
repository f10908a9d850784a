// Which tetrahedra a picture shows: those that no list leaves out and no cut takes away.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "io/mesh_view.hpp"
#include "io/render/picture_request.hpp"

namespace cleft::io
{

// A 1 for each tetrahedron that is shown. Cuts take whole tetrahedra away, by their centres: those in front of all
// cuts, on the side of the eye. Several cuts thus take a corner out of the mesh.
Array<char> shown_tets(const MeshView& mesh, const PictureRequest& request, const Run& run);

}  // namespace cleft::io
