// One tetrahedron of the kernel, in one line of the cache: growing a cavity reads nothing else.
#pragma once

#include "base/fixed_array.hpp"
#include "mesh/tet_mesh.hpp"

#include <cstdint>

namespace cleft
{

// Vertices of the kernel are numbered from 1. The ghost, at infinity, closes the hull: behind each face of the hull is
// a cell of that face and the ghost, so that every face has two cells.
inline constexpr int32_t kGhost = 0;
inline constexpr int32_t kDead = -1;

struct alignas(64) Cell {
    // Positively oriented; the ghost is the last.
    Tet corners;
    // What is behind the face opposite each corner: 4 times a cell, plus the corner of it that is opposite the face.
    FixedArray<int32_t, 4> behind;
    // A point farther from the centre than `outer` is outside of the sphere, and one nearer than `inner` inside, for
    // sure; both are squared. In the frame of the kernel.
    // Of a ghost, neither is true of any point.
    FixedArray<float, 3> centre;
    float inner, outer;
    uint32_t mark;
    uint32_t certified;

    bool is_real() const { return corners[3] > kGhost; }
    bool is_ghost() const { return corners[3] == kGhost; }
    bool is_dead() const { return corners[3] == kDead; }
    void kill() { corners[3] = kDead; }
};
static_assert(sizeof(Cell) == 64);

}  // namespace cleft
