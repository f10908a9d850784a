// Splits edges. The new point takes over the walls that the edge lies in, so the hull keeps its planes.
#include "remeshing/edge_split.hpp"

#include "mesh/adjacency.hpp"

namespace cleft
{

uint8_t frozen_on_edge(const LocalMesh& mesh, const EdgeRing& ring)
{
    // An edge inside the mesh may have both ends in one wall, or in two. Its middle is still free.
    if (ring.closed)
        return 0;
    // Of the two hull faces, not of the ends: two corners of a box have more in common than the edge between them.
    const Vec3 &a = mesh.point(ring.a), &b = mesh.point(ring.b);
    return static_cast<uint8_t>(hull_axes(a, b, mesh.point(ring.points.front())) |
                                hull_axes(a, b, mesh.point(ring.points.back())));
}

void find_split(const LocalMesh& mesh, Cavity& cavity)
{
    const EdgeRing& ring = cavity.ring;
    cavity.clear();
    cavity.old_tets = ring.tets;
    for (const int32_t t : ring.tets)
        for (const int32_t end : {ring.a, ring.b}) {
            Tet half = mesh.tet(t);
            half[mesh.corner_of(t, end)] = kNewPoint;
            cavity.add(half, mesh.material(t));
        }
}

int32_t apply_split(LocalMesh& mesh, const Vec3& x, Cavity& cavity)
{
    const int32_t m = mesh.add_point(x, frozen_on_edge(mesh, cavity.ring));
    cavity.number_new_point(m);
    cavity.apply(mesh);
    return m;
}

}  // namespace cleft
