// The triangles between materials, and how far below the interface they lie.
#pragma once

#include "fitting/meetings.hpp"
#include "volume/volume.hpp"

namespace cleft
{

// A triangle of an interface; its corners wind so that the normal looks from the first material to the second.
struct InterfaceTriangle {
    std::array<int32_t, 3> corners;
    std::array<Material, 2> pair;  // ascending
    double height = 0;             // mean height of the tie above the triangle as it was found
    double offset = 0;             // beyond the tie, for the volumes of the labels
};

std::vector<InterfaceTriangle> find_triangles(const LocalMesh& mesh, const Meetings& meetings, const Run& run);

// Sets the heights. Points in `astray` are not where their materials tie: heights are above the triangle that the
// interface has under it there.
void find_heights(const LocalMesh& mesh, const Volume& volume, const std::vector<int32_t>& astray,
                  std::vector<InterfaceTriangle>& triangles, const Run& run);

}  // namespace cleft
