// Projects points in perspective. The operations are those that IEEE 754 defines to the last bit, so that the places
// are the same on every machine.
#include "io/render/camera.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <limits>

namespace cleft::io
{

namespace
{

// Of the eye from the middle of the mesh, whose farthest points are the square root of 3 away. Nearer, the perspective
// is that of a wide lens; farther, parallel edges look as if they went apart.
constexpr double kDistance = 6.5;
constexpr int64_t kFacesSeen = 1 << 14;  // a chunk

struct Bounds {
    Vector3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                std::numeric_limits<double>::infinity()};
    Vector3 high{-low[0], -low[1], -low[2]};

    void add(const Vector3& p)
    {
        for (size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    }
};

// Of what place(corner) gives for all corners.
template <class Place>
Bounds bounds_of(const Array<OuterFace>& faces, const Run& run, const Place& place)
{
    Array<Bounds> parts(chunk_count(faces.count(), kFacesSeen));
    parallel_chunks(run, faces.count(), kFacesSeen, [&](int64_t chunk, int64_t begin, int64_t end) {
        for (int64_t f = begin; f < end; ++f)
            for (const int32_t corner : faces[f].corners)
                parts[chunk].add(place(corner));
    });
    Bounds all;
    for (const Bounds& part : parts) {
        all.add(part.low);
        all.add(part.high);
    }
    return all;
}

Vector3 of_length_1(const Vector3& v) { return times(1 / std::sqrt(dot(v, v)), v); }

}  // namespace

Camera::Camera(const MeshView& mesh, const Array<OuterFace>& faces, const PictureRequest& request,
               const PixelArea& area, const Run& run)
    : points_(mesh.points),
      right_(of_length_1(cross(request.up, request.to_eye))),
      up_(cross(request.to_eye, right_)),
      to_eye_(request.to_eye)
{
    find_box(faces, run);
    fill_area(faces, area, request.zoom, run);
}

void Camera::find_box(const Array<OuterFace>& faces, const Run& run)
{
    const Bounds box = bounds_of(faces, run, [&](int32_t corner) {
        const double* p = points_ + 3 * int64_t{corner};
        return Vector3{p[0] / 2, p[1] / 2, p[2] / 2};
    });
    for (size_t axis = 0; axis < 3; ++axis) {
        centre_[axis] = box.low[axis] / 2 + box.high[axis] / 2;
        half_ = std::max(half_, box.high[axis] / 2 - box.low[axis] / 2);
    }
    // All points in one place: there is nothing to see, and nothing to divide by.
    if (half_ == 0)
        half_ = 1;
}

void Camera::fill_area(const Array<OuterFace>& faces, const PixelArea& area, double zoom, const Run& run)
{
    const Bounds seen = bounds_of(faces, run, [&](int32_t corner) {
        const Vector3 p = in_frame(corner);
        const double distance = kDistance - p[2];
        return Vector3{p[0] / distance, p[1] / distance, 0};
    });
    const double width = seen.high[0] - seen.low[0];
    const double height = seen.high[1] - seen.low[1];
    if (width > 0 || height > 0)
        scale_ = zoom * std::min(width > 0 ? area.width / width : area.height / height,
                                 height > 0 ? area.height / height : area.width / width);
    from_x_ = (seen.low[0] + seen.high[0]) / 2;
    from_y_ = (seen.low[1] + seen.high[1]) / 2;
    to_x_ = area.left + area.width / 2.0;
    to_y_ = area.top + area.height / 2.0;
}

Vector3 Camera::in_frame(int32_t point) const
{
    const double* p = points_ + 3 * int64_t{point};
    const Vector3 q{(p[0] / 2 - centre_[0]) / half_, (p[1] / 2 - centre_[1]) / half_, (p[2] / 2 - centre_[2]) / half_};
    return {dot(right_, q), dot(up_, q), dot(to_eye_, q)};
}

Vector3 Camera::eye() { return {0, 0, kDistance}; }

ScreenPoint Camera::on_screen(int32_t point) const
{
    const Vector3 p = in_frame(point);
    const double nearness = 1 / (kDistance - p[2]);
    const double x = to_x_ + scale_ * (p[0] * nearness - from_x_);
    const double y = to_y_ - scale_ * (p[1] * nearness - from_y_);
    // 32 bits have room for kGreatestZoom times the greatest picture, see picture_request.cpp.
    return {static_cast<int32_t>(std::floor(x * ScreenPoint::kUnits + 0.5)),
            static_cast<int32_t>(std::floor(y * ScreenPoint::kUnits + 0.5)),
            // In units of the frame where distances near the middle of the mesh are concerned.
            static_cast<float>(kDistance * kDistance * nearness)};
}

double Camera::pixels_per_unit() const { return scale_ / kDistance; }

}  // namespace cleft::io
