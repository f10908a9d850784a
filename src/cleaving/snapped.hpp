// What snapping has made of the vertices of a background: enough to go on from there, or to cut from there, elsewhere.
#pragma once

#include "cleaving/centres.hpp"

namespace cleft
{

struct SnappedVertex {
    int32_t vertex;
    Vec3 x;
    MaterialSet materials;
    bool is_doubtful;
};

// All lists ascend by vertex or tetrahedron.
struct Snapped {
    // Vertices that carry several materials, or are in doubt. All others are as they were.
    Array<SnappedVertex> vertices;
    struct Kept {
        int32_t tet;
        uint16_t material;
    };
    Array<Kept> kept;  // see Centres::kept
};

// Of centres that were snapped.
Snapped snapped_of(const Centres& c);

// Gives the centres of the same background what it had. Cuts and fans follow from the vertices alone.
void restore_snapped(Centres& c, const Snapped& snapped, const Run& run);

}  // namespace cleft
