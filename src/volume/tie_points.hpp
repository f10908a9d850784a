// Points of the interfaces of a volume and of the lines where three materials meet, about one a voxel.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "volume/material_set.hpp"
#include "volume/volume.hpp"

namespace cleft
{

inline constexpr Material kNoThird = -1;

// The two materials of an interface, ascending, or the three of a line.
struct TieMaterials {
    FixedArray<Material, 3> material{0, 0, kNoThird};

    bool is_line() const { return material[2] != kNoThird; }
    bool has(Material m) const { return m == material[0] || m == material[1] || (m == material[2] && is_line()); }
    MaterialSet set() const;

    friend bool operator==(const TieMaterials& a, const TieMaterials& b) { return a.material == b.material; }
    friend bool operator!=(const TieMaterials& a, const TieMaterials& b) { return !(a == b); }
    // Interfaces come before lines.
    friend bool operator<(const TieMaterials& a, const TieMaterials& b)
    {
        return a.is_line() != b.is_line() ? b.is_line() : a.material < b.material;
    }
};

struct TiePoint {
    TieMaterials of;
    Vec3 x;
};

// Where the tie of two materials crosses the line between two neighbouring voxel centres, in the order of the voxels.
// Where a third material holds at the crossing there is none: what ties there is no interface.
Array<TiePoint> find_interface_points(const Volume& volume, const Run& run);

// Where the tie of three materials crosses a square of four neighbouring voxel centres.
Array<TiePoint> find_line_points(const Volume& volume, const Run& run);

// Whether some of the materials hold at x, where they tie: none of the others is greater by more than what a step of
// `tolerance` changes.
bool is_held_by(const Volume& volume, const Vec3& x, const MaterialSet& set, double tolerance, Samples& scratch);

}  // namespace cleft
