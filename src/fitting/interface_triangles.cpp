// Finds the triangles between materials.
#include "fitting/interface_triangles.hpp"

#include "mesh/adjacency.hpp"

#include <algorithm>

namespace cleft
{

// Only tetrahedra with three points of interfaces can have a triangle in one.
Array<InterfaceTriangle> find_triangles(const LocalMesh& mesh, const Meetings& meetings, const Run& run)
{
    const auto is_inside = [&](int32_t v) { return meetings[v] < Meeting::interface; };
    Array<InterfaceTriangle> triangles;
    triangles.reserve(mesh.slot_count() / 8);
    for (int32_t t = 0; t < mesh.slot_count(); ++t) {
        run.check_at(t);
        if (!mesh.alive(t))
            continue;
        const Tet& corners = mesh.tet(t);
        for (int face = 0; face < 4; ++face) {
            const auto& f = kFaceCorners[face];
            const std::array<int32_t, 3> points{corners[f[0]], corners[f[1]], corners[f[2]]};
            if (std::any_of(points.begin(), points.end(), is_inside))
                continue;
            const int32_t behind = mesh.neighbour(t, face);
            // Taken from the side of the lesser material alone, so each triangle comes once and looks to the greater
            // one.
            if (behind >= 0 && mesh.material(t) < mesh.material(behind))
                triangles.push_back({points, {mesh.material(t), mesh.material(behind)}});
        }
    }
    return triangles;
}

}  // namespace cleft
