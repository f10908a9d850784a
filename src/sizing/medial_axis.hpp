// The medial axis of the materials: the places inside a material from which the nearest interface points lie in
// opposite directions. The distance from it, read at an interface, is the local feature size.
#pragma once

#include "base/array.hpp"
#include "sizing/interface_points.hpp"

#include <cstdint>

namespace cleft
{

// What a voxel holds of the medial axis: nothing (0), or one place in a byte. Either on the way from its centre to that
// of the next voxel along an axis, in steps of 1/63, or half a voxel or none away from its centre along each axis.
constexpr int kMedialSteps = 63;

// `part` of the way to the next voxel along the axis. The code is above kMedialSteps, which tells it from the other
// form.
inline uint8_t pack_medial(int axis, double part)
{
    CLEFT_ASSERT(part >= 0 && part <= 1);
    return static_cast<uint8_t>((axis + 1) << 6 | static_cast<int>(part * kMedialSteps + 0.5));
}

// halves: -1, 0 or 1 half a voxel along each axis.
inline uint8_t pack_medial(const FixedArray<int, 3>& halves)
{
    return static_cast<uint8_t>(1 + (halves[0] + 1) + 3 * (halves[1] + 1) + 9 * (halves[2] + 1));
}

// The place, relative to the voxel's centre.
inline Vec3 medial_offset(uint8_t held, const Vec3& spacing)
{
    CLEFT_ASSERT(held != 0);
    if (held <= kMedialSteps) {
        const int halves = held - 1;
        const int i = halves % 3 - 1, j = halves / 3 % 3 - 1, k = halves / 9 - 1;
        return 0.5 * Vec3(i, j, k).cwiseProduct(spacing);
    }
    Vec3 offset = Vec3::Zero();
    const int axis = (held >> 6) - 1;
    offset[axis] = (held & kMedialSteps) * spacing[axis] / kMedialSteps;
    return offset;
}

// A feature transform and its reach.
struct NearestSites {
    Array<int32_t> site;
    double reach;

    // A voxel whose site is within this distance has neighbours, over faces, edges and corners, whose sites are known
    // and exact. The share is more than the rounding of distances.
    double certain_beside(const Grid& grid) const { return reach - 1.01 * grid.spacing.norm(); }
};

// Adds the places between neighbouring voxels whose nearest interface points differ, and the deepest voxels: `nearest`
// is the feature transform of the interface voxels. Only those of voxels that have certain neighbours.
void add_medial_places(const Labelling& labelling, const InterfacePoints& points, const NearestSites& nearest,
                       Array<uint8_t>& medial, const Run& run);

}  // namespace cleft
