// Takes tetrahedra and points out of a mesh, and numbers the rest anew.
#include "mesh/strip.hpp"

namespace cleft
{

void drop_unused_points(Array<Vec3>& points, Array<Tet>& tets)
{
    Array<int32_t> number(points.size(), -1);
    for (const Tet& tet : tets)
        for (const int32_t p : tet)
            number[p] = 0;
    // Points move to places that have been read already, so the mesh is never held twice.
    int32_t kept = 0;
    for (size_t p = 0; p < points.size(); ++p)
        if (number[p] == 0) {
            number[p] = kept;
            points[kept++] = points[p];
        }
    points.resize(kept);
    for (Tet& tet : tets)
        for (int32_t& p : tet)
            p = number[p];
}

void strip(Array<Vec3>& points, Array<Tet>& tets, Array<int32_t>& regions,
           const std::function<bool(int32_t region)>& keeps)
{
    CLEFT_ASSERT(regions.size() == tets.size());
    size_t kept = 0;
    for (size_t t = 0; t < tets.size(); ++t) {
        if (!keeps(regions[t]))
            continue;
        tets[kept] = tets[t];
        regions[kept++] = regions[t];
    }
    tets.resize(kept);
    regions.resize(kept);
    drop_unused_points(points, tets);
}

}  // namespace cleft
