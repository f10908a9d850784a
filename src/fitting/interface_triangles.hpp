// The triangles between materials.
#pragma once

#include "base/array.hpp"
#include "fitting/meetings.hpp"

namespace cleft
{

// A triangle of an interface; its corners wind so that the normal looks from the first material to the second.
struct InterfaceTriangle {
    std::array<int32_t, 3> corners;
    std::array<Material, 2> pair;  // ascending
    double height = 0;             // mean height of the tie above the triangle as it was found
    double offset = 0;             // beyond the tie, for the volumes of the labels
};

Array<InterfaceTriangle> find_triangles(const LocalMesh& mesh, const Meetings& meetings, const Run& run);

}  // namespace cleft
