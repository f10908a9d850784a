// The faces that look towards the eye, with their colours in the light.
#pragma once

#include "io/colour.hpp"
#include "io/render/camera.hpp"
#include "io/render/colour_scale.hpp"
#include "io/render/outer_faces.hpp"
#include "io/render/picture_request.hpp"
#include "io/render/tile.hpp"

#include <optional>

namespace cleft::io
{

struct DrawnFace {
    int32_t corners[3];  // points of the mesh
    int32_t tet;
    FaceColours colours;
};

// Measures of the tetrahedra of faces, one a face; none if the colour is that of the label. In units of the mesh.
Array<double> face_measures(const MeshView& mesh, const Array<OuterFace>& faces, const Camera& camera,
                            const PictureRequest& request, const Run& run);

// The order of the faces is kept. `scale` is there if `measures` are.
Array<DrawnFace> drawn_faces(const MeshView& mesh, const Array<OuterFace>& faces, const Array<double>& measures,
                             const std::optional<ColourScale>& scale, const Camera& camera,
                             const PictureRequest& request, const Run& run);

}  // namespace cleft::io
