// The triangles between materials.
#pragma once

#include "base/array.hpp"
#include "fitting/meetings.hpp"

namespace cleft
{

// A triangle of an interface; its corners wind so that the normal looks from the first material to the second.
struct InterfaceTriangle {
    std::array<int32_t, 3> corners;                 // points of the mesh
    std::array<Material, 2> pair;                   // ascending
    std::array<int32_t, 3> fit_points{-1, -1, -1};  // the corners' places among those of find_points()
    double height = 0;                              // mean height of the tie above the triangle as it was found
    double offset = 0;                              // beyond the tie, for the volumes of the labels
};

// Along the normal, and as long as the area.
inline Vec3 area_vector(const LocalMesh& mesh, const InterfaceTriangle& t)
{
    const Vec3& a = mesh.point(t.corners[0]);
    return 0.5 * (mesh.point(t.corners[1]) - a).cross(mesh.point(t.corners[2]) - a);
}

Array<InterfaceTriangle> find_triangles(const LocalMesh& mesh, const Meetings& meetings, const Run& run);

}  // namespace cleft
