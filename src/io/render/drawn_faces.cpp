// Gives each face its colour: that of its label or measure, in the light of two lamps.
#include "io/render/drawn_faces.hpp"

#include "base/collect.hpp"
#include "io/label_colours.hpp"
#include "io/render/tet_measure.hpp"

namespace cleft::io
{

namespace
{

constexpr int64_t kFaces = 1 << 12;  // a chunk

// In the frame of the eye. The first lamp stands above the left shoulder; the second keeps what it does not reach from
// being flat. Directions of length 1.
constexpr Vector3 kLamp{-0.424, 0.566, 0.707};
constexpr Vector3 kSecondLamp{0.814, -0.116, 0.569};
// The sum is 1 for a face that looks into the first lamp. Tuned on AAL and the electrode: with less of the even light,
// the sides of single tetrahedra stand out more than the labels.
constexpr double kEvenLight = 0.66;
constexpr double kLight = 0.34;
constexpr double kSecondLight = 0.08;
// Shade is bluish and never black, so that hues can be told in it.
constexpr Colour kShade{22, 26, 44};
constexpr Colour kLine{18, 20, 28};
constexpr int kDarkestLine = kWhole * 7 / 10;
// Triangles are seen if their lines leave most of them free: lines of a triangle whose inner circle has this radius, in
// widths of a line, have their whole strength; those of smaller ones fade.
constexpr double kFullLineRadius = 4.5;

double light_on(const Vector3& normal)
{
    return std::min(1.0, kEvenLight + kLight * std::max(0.0, dot(normal, kLamp)) +
                             kSecondLight * std::max(0.0, dot(normal, kSecondLamp)));
}

// The normal of a face, of length 1, away from its tetrahedron. A face of no area is drawn by no sample.
Vector3 outward_normal(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& inner)
{
    const Vector3 normal = cross(minus(b, a), minus(c, a));
    const double size = std::sqrt(dot(normal, normal));
    if (!(size > 0))
        return {0, 0, 1};
    return times((dot(normal, minus(inner, a)) > 0 ? -1 : 1) / size, normal);
}

double distance(const ScreenPoint& a, const ScreenPoint& b)
{
    const double x = double(b.x) - a.x, y = double(b.y) - a.y;
    return std::sqrt(x * x + y * y);
}

// Of the circle inside a triangle on the picture, in pixels.
double inner_radius(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c)
{
    const double around = distance(a, b) + distance(b, c) + distance(c, a);
    const double two_areas = (double(b.x) - a.x) * (double(c.y) - a.y) - (double(b.y) - a.y) * (double(c.x) - a.x);
    return around > 0 ? std::abs(two_areas) / around / ScreenPoint::kUnits : 0;
}

// How dark the lines of a face are, in parts of 256.
int line_strength(const Camera& camera, const OuterFace& face, const PictureRequest& request)
{
    if (!request.has_edges)
        return 0;
    const int32_t* c = face.corners;
    const double radius = inner_radius(camera.on_screen(c[0]), camera.on_screen(c[1]), camera.on_screen(c[2]));
    const double share = std::min(1.0, radius / (kFullLineRadius * request.line_width));
    return static_cast<int>(kDarkestLine * share);
}

}  // namespace

Array<double> face_measures(const MeshView& mesh, const Array<OuterFace>& faces, const Camera& camera,
                            const PictureRequest& request, const Run& run)
{
    if (request.by == CLEFT_IO_BY_LABEL)
        return {};
    const double unit = request.by == CLEFT_IO_BY_SIZE ? camera.length_of_unit() : 1;
    Array<double> measures(faces.count());
    parallel_for(run, faces.count(), kFaces, [&](int64_t begin, int64_t end) {
        for (int64_t f = begin; f < end; ++f) {
            const int32_t* tet = mesh.tets + 4 * int64_t{faces[f].tet};
            measures[f] = unit * tet_measure(request.by, {camera.in_frame(tet[0]), camera.in_frame(tet[1]),
                                                          camera.in_frame(tet[2]), camera.in_frame(tet[3])});
        }
    });
    return measures;
}

Array<DrawnFace> drawn_faces(const MeshView& mesh, const Array<OuterFace>& faces, const Array<double>& measures,
                             const std::optional<ColourScale>& scale, const Camera& camera,
                             const PictureRequest& request, const Run& run)
{
    const auto add = [&](int64_t f, Array<DrawnFace>& drawn) {
        const OuterFace& face = faces[f];
        const Vector3 a = camera.in_frame(face.corners[0]);
        const Vector3 normal = outward_normal(a, camera.in_frame(face.corners[1]), camera.in_frame(face.corners[2]),
                                              camera.in_frame(face.inner));
        // A face that looks away is hidden by the tetrahedron that it bounds.
        if (!(dot(normal, minus(Camera::eye(), a)) > 0))
            return;
        const Colour own = scale ? scale->of(measures[f]) : colour_of_label(mesh.tet_labels[face.tet]);
        const Colour lit = mixed(own, kShade, static_cast<int>((1 - light_on(normal)) * kWhole));
        drawn.push_back({{face.corners[0], face.corners[1], face.corners[2]},
                         face.tet,
                         {lit, mixed(lit, kLine, line_strength(camera, face, request))}});
    };
    return collect<DrawnFace>(run, faces.count(), kFaces, [&](int64_t begin, int64_t end, Array<DrawnFace>& drawn) {
        for (int64_t f = begin; f < end; ++f)
            add(f, drawn);
    });
}

}  // namespace cleft::io
