// The areas of contact and the deficits give offsets of materials; those of the two materials give that of a triangle.
#include "fitting/offsets.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Interfaces of label maps go no further beyond the tie than this, in the least voxel spacing.
// A greater limit would give small labels more of their volume, but move interfaces further from where voxels put them.
constexpr double kMostOffset = 0.2;
// And than this at a small label that is still off after the first rounds.
// With it, shells one voxel thick keep their volume within 5 %. At 0.5 voxels the two sides of a shell could meet.
constexpr double kWideOffset = 0.45;

SharedArea& shared_area_of(Array<SharedArea>& shared, const std::array<Material, 2>& pair)
{
    const auto found =
        std::lower_bound(shared.begin(), shared.end(), pair, [](const SharedArea& c, const auto& wanted) {
            return c.first != wanted[0] ? c.first < wanted[0] : c.second < wanted[1];
        });
    CLEFT_ASSERT(found != shared.end() && found->first == pair[0] && found->second == pair[1]);
    return *found;
}

void add_areas(const LocalMesh& mesh, const Array<InterfaceTriangle>& triangles, Array<SharedArea>& shared)
{
    for (const InterfaceTriangle& t : triangles)
        shared_area_of(shared, t.pair).area += area_vector(mesh, t).norm();
}

// What materials gain where each triangle rises to its height.
void take_heights_off(const LocalMesh& mesh, const Array<InterfaceTriangle>& triangles, Array<double>& missing)
{
    for (const InterfaceTriangle& t : triangles) {
        const double gain = area_vector(mesh, t).norm() * t.height;
        missing[t.pair[0]] -= gain;
        missing[t.pair[1]] += gain;
    }
}

}  // namespace

Array<SharedArea> find_shared_areas(const Array<InterfaceTriangle>& triangles)
{
    Array<std::array<Material, 2>> pairs;
    for (const InterfaceTriangle& t : triangles)
        // Neighbours mostly have the same pair, so this keeps the list short.
        if (pairs.empty() || pairs.back() != t.pair)
            pairs.push_back(t.pair);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    Array<SharedArea> shared;
    for (const auto& pair : pairs)
        shared.push_back({pair[0], pair[1], 0});
    return shared;
}

void add_offsets(const LocalMesh& mesh, const VolumeDeficits& deficits, const Vec3& spacing, bool first,
                 Array<SharedArea> shared, Array<InterfaceTriangle>& triangles)
{
    add_areas(mesh, triangles, shared);
    Array<double> missing = deficits.missing();
    if (first)
        take_heights_off(mesh, triangles, missing);
    const Array<double> offsets = material_offsets(shared, missing);
    for (InterfaceTriangle& t : triangles) {
        const double more = offsets[t.pair[0]] - offsets[t.pair[1]];
        const bool is_wide = deficits.is_wide(t.pair[0]) || deficits.is_wide(t.pair[1]);
        const double most = (is_wide ? kWideOffset : kMostOffset) * spacing.minCoeff();
        t.offset = std::clamp(t.offset + more, -most, most);
    }
}

}  // namespace cleft
