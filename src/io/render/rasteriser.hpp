// Draws triangles: which of them each pixel shows, and how much of it.
#pragma once

#include "base/array.hpp"
#include "io/render/camera.hpp"
#include "io/render/canvas.hpp"
#include "io/render/drawn_faces.hpp"

namespace cleft::io
{

// Draws the faces on an empty canvas, nearer ones before others; of two equally near, the first in the list. Lines of
// `line_width` pixels run along the edges of each, half of a line in each of two faces, all of it where there is one.
// Returns which faces are seen.
Array<uint8_t> rasterise(const MeshView& mesh, const Array<DrawnFace>& faces, const Camera& camera, double line_width,
                         const Run& run, Canvas& canvas);

}  // namespace cleft::io
