// How much the interfaces of a volume are curved.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "volume/tie_points.hpp"
#include "volume/volume.hpp"

#include <array>

namespace cleft
{

// At a point of an interface, the greatest principal curvature: one over a length. 0 where too few points are near.
struct CurvedPoint {
    Vec3 x;
    float curvature;
};

// How an interface bends at a point of it: along two directions in its tangent plane, which are those of the least and
// the greatest curvature. A curvature is negative where too few points are near to tell it.
struct Bend {
    Vec3 x, normal;
    std::array<Vec3, 2> along;
    std::array<double, 2> curvature;
};

// At each point of find_interface_points(), as surface_curvatures() finds it.
Array<Bend> surface_bends(const Volume& volume, const Run& run);

// At each point of find_interface_points().
//   The normals of the points of the same interface in a window of some voxels around are fitted by a linear function
// of their places in the tangent plane, by least squares: its slope is the curvature tensor. On a sphere and on a
// cylinder this is exact for any window. A window averages the steps that are left of the voxels of a label map: over a
// single voxel, they bend the interface more than the shapes do.
Array<CurvedPoint> surface_curvatures(const Volume& volume, const Run& run);

}  // namespace cleft
