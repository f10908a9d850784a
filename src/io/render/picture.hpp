// The way from a mesh to a picture.
#pragma once

#include "io/mesh_view.hpp"
#include "io/render/canvas.hpp"
#include "io/render/picture_request.hpp"

#include "base/run.hpp"

namespace cleft::io
{

// Throws Error(CLEFT_ERROR_ARGUMENT) if nothing is left to show. The pixels do not depend on the threads of `run` nor
// on the machine. The cover is 255 unless there is no backdrop.
Canvas draw_picture(const MeshView& mesh, const PictureRequest& request, const Run& run);

}  // namespace cleft::io
