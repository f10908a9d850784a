// Where a point of the mesh comes to lie on the picture.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "io/mesh_view.hpp"
#include "io/render/outer_faces.hpp"
#include "io/render/picture_request.hpp"

#include <cstdint>

namespace cleft::io
{

// A part of a picture, in pixels.
struct PixelArea {
    int left = 0, top = 0, width = 0, height = 0;
};

// A place on the picture. Whole numbers: triangles that share an edge share it to the last bit, and every machine
// decides alike which of them has a sample.
struct ScreenPoint {
    static constexpr int32_t kUnits = 1024;  // steps a pixel

    int32_t x = 0, y = 0;  // to the right and downwards, from the corner of the picture
    float depth = 0;       // above 0, greater for what is nearer. It is linear on the picture of a plane
};

// Looks at the faces from the direction that the request says, so that they fill the area.
class Camera
{
public:
    // There must be at least one face.
    Camera(const MeshView& mesh, const Array<OuterFace>& faces, const PictureRequest& request, const PixelArea& area,
           const Run& run);

    // In the frame of the eye: x to the right, y upwards, z towards the eye. The faces lie in a ball around the origin;
    // a unit is half of the longest side of their box.
    Vector3 in_frame(int32_t point) const;
    static Vector3 eye();
    // Only of corners of the faces.
    ScreenPoint on_screen(int32_t point) const;
    // Of a unit of the frame, in the middle of the mesh.
    double pixels_per_unit() const;
    // A unit of the frame in units of the mesh.
    double length_of_unit() const { return 2 * half_; }

private:
    void find_box(const Array<OuterFace>& faces, const Run& run);
    void fill_area(const Array<OuterFace>& faces, const PixelArea& area, double zoom, const Run& run);

    const double* points_;
    Vector3 right_, up_, to_eye_;
    Vector3 centre_{};                // halves of the coordinates, for their sums may overflow
    double half_ = 0;                 // a quarter of the longest side of the box
    double scale_ = 1;                // from the plane at distance 1 of the eye to pixels
    double from_x_ = 0, from_y_ = 0;  // on that plane, what comes to lie in the middle of the area
    double to_x_ = 0, to_y_ = 0;      // that middle
};

}  // namespace cleft::io
