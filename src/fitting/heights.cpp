// Looks for the tie along the normal of each triangle.
#include "fitting/heights.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace cleft
{

namespace
{

// The interface is looked for within this share of a triangle's longest edge: the centroid of a triangle with edges h
// on a sphere of radius h lies 0.18 h below it.
constexpr double kReachOfTriangle = 0.3;
// Steps of the search, in the least voxel spacing: label indicators are flat further away than that.
constexpr double kStep = 0.4;
// No search takes more steps: in voxels a thousand times as long as wide there would be hundreds.
constexpr int kMostSteps = 64;
// See find_heights() below: it follows from the shape, and is not tuned.
constexpr double kCentroidShare = 0.75;
// User-supplied fields say where surfaces are to a small part of a voxel, and points on a ball cannot be on its
// surface while it keeps its volume: there points give up so much less of their place, in radii of the curvature, which
// costs a ball three times so much of its volume; but no more than this share of a height, which vanishes with the
// edge length.
constexpr double kSlackOfFields = 0.00064;
constexpr double kSlackShare = 0.45;
// Without this limit, coarse meshes of two balls that touch lost a hundredth of the volume next to the gap.
constexpr double kMostCurved = 1.5;
// Triangles that a thread takes at a time. Each has its own height, so this number changes the time alone.
constexpr int64_t kTrianglesFitted = 2048;

// By how much the first material of a pair leads the second at a point; not ok if a third one wins there.
struct Lead {
    double difference;
    bool ok;
};

Lead side_at(const Volume& volume, const Vec3& x, const std::array<Material, 2>& pair, Samples& samples)
{
    volume.sample(x, samples);
    const Material best = samples.material[samples.best()];
    const auto value = [&](Material m) {
        const int at = samples.find(m);
        return at < 0 ? 0.0 : samples.value[at];
    };
    return {value(pair[0]) - value(pair[1]), best == pair[0] || best == pair[1]};
}

// Where the tie of the pair lies on the line from x along the unit normal (which looks from the first material to the
// second): positive if beyond x. None if it is not met within `reach`.
std::optional<double> height_of_tie(const Volume& volume, const Vec3& x, const Vec3& normal,
                                    const std::array<Material, 2>& pair, double reach, double step, Samples& samples)
{
    // The side says in which direction the tie lies, so only one half of the line is searched.
    Lead near = side_at(volume, x, pair, samples);
    if (!near.ok)
        return std::nullopt;
    const double direction = near.difference > 0 ? 1 : -1;
    double at = 0;
    for (int steps = 0; steps <= kMostSteps && at < reach; ++steps) {
        const double next = std::min(reach, at + step);
        const Lead far = side_at(volume, x + direction * next * normal, pair, samples);
        // A third material lies between: what comes behind it is another interface.
        if (!far.ok)
            return std::nullopt;
        if (far.difference * near.difference <= 0) {
            if (near.difference == far.difference)
                return direction * at;
            const double share = near.difference / (near.difference - far.difference);
            return direction * (at + share * (next - at));
        }
        at = next;
        near = far;
    }
    return std::nullopt;
}

// How much of its height a triangle gives up. The mean height of a sphere of radius R above a triangle in it is the sum
// of the squared edge lengths / (24 R).
double slack_of(double height, double squared_edges)
{
    // The bound keeps a flat triangle from dividing by zero.
    const double radius = squared_edges / (24 * std::max(std::abs(height), 1e-300));
    return std::copysign(std::min(kSlackOfFields * radius, kSlackShare * std::abs(height)), height);
}

double squared_edges(const LocalMesh& mesh, const InterfaceTriangle& t)
{
    const Vec3 &a = mesh.point(t.corners[0]), &b = mesh.point(t.corners[1]), &c = mesh.point(t.corners[2]);
    return (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
}

// Next to a gap a triangle may look at an interface that is not under it: none there is more than so much more curved
// than all others are on the mean.
void limit_heights(const LocalMesh& mesh, const Array<uint8_t>& is_limited, Array<InterfaceTriangle>& triangles)
{
    double heights = 0, squares = 0;
    for (size_t i = 0; i < triangles.size(); ++i)
        if (!is_limited[i]) {
            heights += std::abs(triangles[i].height);
            squares += squared_edges(mesh, triangles[i]);
        }
    for (size_t i = 0; i < triangles.size(); ++i)
        if (is_limited[i]) {
            const double most = squares > 0 ? kMostCurved * heights / squares * squared_edges(mesh, triangles[i]) : 0;
            triangles[i].height = std::clamp(triangles[i].height, -most, most);
        }
}

}  // namespace

// A quadratic function that is zero at the corners has 3/4 of its value at the centroid as its mean over the triangle.
void find_heights(const LocalMesh& mesh, const Volume& volume, const Array<int32_t>& without_tie,
                  Array<InterfaceTriangle>& triangles, const Run& run)
{
    Array<uint8_t> is_without_tie(mesh.point_count(), 0);
    for (const int32_t v : without_tie)
        is_without_tie[v] = 1;
    Array<uint8_t> is_limited(triangles.size(), 0);
    const double step = kStep * volume.grid().spacing.minCoeff();
    parallel_for(run, triangles.count(), kTrianglesFitted, [&](int64_t begin, int64_t end) {
        Samples samples;
        for (int64_t i = begin; i < end; ++i) {
            InterfaceTriangle& t = triangles[i];
            const Vec3 &a = mesh.point(t.corners[0]), &b = mesh.point(t.corners[1]), &c = mesh.point(t.corners[2]);
            const Vec3 normal = (b - a).cross(c - a).normalized();
            const double reach =
                kReachOfTriangle *
                std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
            const auto height_at = [&](const Vec3& x) {
                return height_of_tie(volume, x, normal, t.pair, reach, std::max(step, reach / kMostSteps), samples);
            };
            std::optional<double> height = height_at((a + b + c) / 3);
            for (const int32_t v : t.corners)
                if (is_without_tie[v]) {
                    is_limited[i] = 1;
                    const auto corner = height ? height_at(mesh.point(v)) : std::nullopt;
                    height = corner ? std::optional(*height - *corner / 3) : std::nullopt;
                }
            t.height = kCentroidShare * height.value_or(0);
            if (!volume.is_label_map())
                t.height -= slack_of(t.height, squared_edges(mesh, t));
        }
    });
    if (!without_tie.empty())
        limit_heights(mesh, is_limited, triangles);
}

}  // namespace cleft
