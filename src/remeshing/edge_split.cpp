// Splits edges. The new point takes over the walls that the edge lies in, so the hull keeps its planes.
#include "remeshing/edge_split.hpp"

namespace cleft
{

uint8_t frozen_on_edge(const LocalMesh& mesh, const EdgeRing& ring)
{
    // An edge inside the mesh may have both ends in one wall, or in two. Its middle is still free.
    if (ring.closed)
        return 0;
    return mesh.frozen(ring.a) & mesh.frozen(ring.b);
}

int32_t split_edge(LocalMesh& mesh, const EdgeRing& ring, const Vec3& x, Cavity& cavity)
{
    const int32_t m = mesh.add_point(x, frozen_on_edge(mesh, ring));
    cavity.clear();
    cavity.old_tets = ring.tets;
    for (const int32_t t : ring.tets)
        for (const int32_t end : {ring.a, ring.b}) {
            Tet half = mesh.tet(t);
            half[mesh.corner_of(t, end)] = m;
            cavity.add(half, mesh.material(t));
        }
    cavity.apply(mesh);
    return m;
}

}  // namespace cleft
