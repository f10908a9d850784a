// Finds the triangles between materials.
#include "fitting/interface_triangles.hpp"

#include "base/collect.hpp"
#include "mesh/adjacency.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Tetrahedra that a thread looks at. The number changes the time alone.
constexpr int64_t kTetsAtOnce = 1 << 13;

// Only tetrahedra with three points of interfaces can have a triangle in one.
void add_triangles(const LocalMesh& mesh, const Meetings& meetings, int32_t t, Array<InterfaceTriangle>& triangles)
{
    const auto is_inside = [&](int32_t v) { return meetings[v] < Meeting::interface; };
    const Tet& corners = mesh.tet(t);
    for (int face = 0; face < 4; ++face) {
        const auto& f = kFaceCorners[face];
        const std::array<int32_t, 3> points{corners[f[0]], corners[f[1]], corners[f[2]]};
        if (std::any_of(points.begin(), points.end(), is_inside))
            continue;
        const int32_t behind = mesh.neighbour(t, face);
        // Taken from the side of the lesser material alone, so each triangle comes once and looks to the greater one.
        if (behind >= 0 && mesh.material(t) < mesh.material(behind))
            triangles.push_back({points, {mesh.material(t), mesh.material(behind)}});
    }
}

}  // namespace

Array<InterfaceTriangle> find_triangles(const LocalMesh& mesh, const Meetings& meetings, const Run& run)
{
    return collect<InterfaceTriangle>(run, mesh.slot_count(), kTetsAtOnce,
                                      [&](int64_t begin, int64_t end, Array<InterfaceTriangle>& triangles) {
                                          for (auto t = static_cast<int32_t>(begin); t < end; ++t)
                                              if (mesh.alive(t))
                                                  add_triangles(mesh, meetings, t, triangles);
                                      });
}

}  // namespace cleft
