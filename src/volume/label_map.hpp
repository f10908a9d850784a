// A label map as it is stored: dense materials and two bytes of weights a voxel, whatever the number of materials.
//
// The indicator of material k at x is the share of k in
//     f_k(x) = sum_v A(v) w(x - v) [material(v) = k]  +  sum over the 8 nearest centres v of B(v) s(x - v) [material(v)
//     = k]
// with the Hann kernel w and the bump s (hann.hpp). A keeps the volume of each material, B keeps every voxel centre
// (label_weights.hpp).
//
// Outside the grid the map goes on as its mirror image in the faces of the box. An interface then meets the box at
// right angles, which is where good dihedral angles need it.
#pragma once

#include "base/array.hpp"
#include "base/grid.hpp"
#include "mesh/tet_mesh.hpp"
#include "volume/hann.hpp"

#include <cstdint>

namespace cleft
{

// A(v) and B(v) are stored in steps of 1/64.
// The greatest A bounds what B can be asked for: the weights of the kernel add up to one, so at a voxel centre no other
// material has more than the greatest A. A byte always holds the B that keeps the centre, and leaves codes for the
// depth of voxels that need none.
// The least A is a quarter. It bounds how far feedback weakens a voxel: with A = 0 everywhere around a point, no
// material would have a share there. The greatest is 2.9, and leaves 64 codes for depths.
constexpr int kWeightOne = 64;
constexpr int kWeightLeast = 16;
constexpr int kWeightGreatest = 184;
constexpr int kBumpGreatest = 191;

static_assert(kBumpGreatest >= kWeightGreatest + 2, "B must be able to keep a voxel centre by its margin");

// A voxel of the band (one of its 26 neighbours differs) has B as its code. All others have their depth, past
// kBumpGreatest, and need no B.
constexpr int kDepthGreatest = 255 - kBumpGreatest;

inline bool in_band(uint8_t code) { return code <= kBumpGreatest; }
// All voxels within this distance, in the maximum norm, are of the same material.
inline int depth_of(uint8_t code) { return in_band(code) ? 0 : code - kBumpGreatest; }
inline int bump_of(uint8_t code) { return in_band(code) ? code : 0; }

template <class Label>
struct LabelMap {
    Grid grid;
    Hann kernel{5};
    // The planes that may be sampled. A part of a large map holds these and some around them.
    Planes planes;
    int64_t first = 0;  // the voxel that the arrays begin with
    // Each padded by kLanes entries, so that whole lanes can be read at any voxel.
    Array<Label> material;
    Array<uint8_t> weight;  // A
    Array<uint8_t> code;    // B or depth

    // A point sees no voxel farther than this from its nearest one.
    int reach() const { return kernel.width() / 2; }
    // Where the arrays have a voxel.
    int64_t index(int32_t i, int32_t j, int32_t k) const { return grid.index(i, j, k) - first; }
};

// i, or the index of the voxel of which the voxel i outside 0 .. n-1 is a mirror image.
inline int32_t mirrored(int32_t i, int32_t n)
{
    // Nearly all indices are inside, and a division costs more than the rest.
    if (i >= 0 && i < n)
        return i;
    // The mirror lies between voxels: the image of voxel 0 is -1, and the pattern repeats after 2 n. A grid of one
    // voxel needs several reflections.
    const int64_t period = 2 * int64_t{n};
    const int64_t m = ((i % period) + period) % period;
    return static_cast<int32_t>(m < n ? m : period - 1 - m);
}

}  // namespace cleft
