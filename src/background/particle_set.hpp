// The particles of a box and the walls that hold them.
#pragma once

#include "base/array.hpp"
#include "base/vec.hpp"

#include <cstdint>

namespace cleft
{

// Bit a is set where the coordinate of axis a is held: it is exactly 0 or the extent of the box.
using Walls = uint8_t;

// This bit is set where the particle has its place already, and does not move at all.
inline constexpr Walls kFixed = 8;

inline bool held(Walls walls, int axis) { return (walls >> axis & 1) != 0; }
inline bool may_move(Walls walls, int axis) { return !held(walls, axis) && (walls & kFixed) == 0; }
// 0 inside, 1 on a face, 2 on an edge, 3 in a corner of the box.
inline int wall_count(Walls walls) { return (walls & 1) + (walls >> 1 & 1) + (walls >> 2 & 1); }
// The share of the particle that belongs to the box; the rest belongs to its mirror images.
inline double share_of_box(Walls walls) { return 1.0 / (1 << wall_count(walls)); }

struct ParticleSet {
    Array<Vec3> x;
    Array<Walls> walls;

    size_t size() const { return x.size(); }
    int64_t count() const { return x.count(); }
    void add(const Vec3& point, Walls w)
    {
        x.push_back(point);
        walls.push_back(w);
    }
};

}  // namespace cleft
