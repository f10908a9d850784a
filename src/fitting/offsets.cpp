// The areas of contact and the deficits give offsets of materials; those of the two materials give that of a triangle.
#include "fitting/offsets.hpp"

#include "base/parallel.hpp"

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
// Triangles that a thread takes. The number changes the time alone.
constexpr int64_t kTrianglesAtOnce = 4096;

SharedArea& shared_area_of(Array<SharedArea>& shared, const std::array<Material, 2>& pair)
{
    const auto found =
        std::lower_bound(shared.begin(), shared.end(), pair, [](const SharedArea& c, const auto& wanted) {
            return c.first != wanted[0] ? c.first < wanted[0] : c.second < wanted[1];
        });
    CLEFT_ASSERT(found != shared.end() && found->first == pair[0] && found->second == pair[1]);
    return *found;
}

Array<double> areas_of(const LocalMesh& mesh, const Array<InterfaceTriangle>& triangles, const Run& run)
{
    Array<double> areas(triangles.size());
    parallel_for(run, triangles.count(), kTrianglesAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t t = begin; t < end; ++t)
            areas[t] = area_vector(mesh, triangles[t]).norm();
    });
    return areas;
}

// In the order of the triangles: neighbours mostly have the same pair.
void add_areas(const Array<InterfaceTriangle>& triangles, const Array<double>& areas, Array<SharedArea>& shared)
{
    const std::array<Material, 2>* last = nullptr;
    SharedArea* of_last = nullptr;
    for (size_t t = 0; t < triangles.size(); ++t) {
        if (!last || *last != triangles[t].pair) {
            last = &triangles[t].pair;
            of_last = &shared_area_of(shared, *last);
        }
        of_last->area += areas[t];
    }
}

// What materials gain where each triangle rises to its height.
void take_heights_off(const Array<InterfaceTriangle>& triangles, const Array<double>& areas, Array<double>& missing)
{
    for (size_t t = 0; t < triangles.size(); ++t) {
        const double gain = areas[t] * triangles[t].height;
        missing[triangles[t].pair[0]] -= gain;
        missing[triangles[t].pair[1]] += gain;
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
                 Array<SharedArea> shared, Array<InterfaceTriangle>& triangles, const Run& run)
{
    const Array<double> areas = areas_of(mesh, triangles, run);
    add_areas(triangles, areas, shared);
    Array<double> missing = deficits.missing();
    if (first)
        take_heights_off(triangles, areas, missing);
    const Array<double> offsets = material_offsets(shared, missing);
    const double usual = kMostOffset * spacing.minCoeff(), wide = kWideOffset * spacing.minCoeff();
    parallel_for(run, triangles.count(), kTrianglesAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            InterfaceTriangle& t = triangles[i];
            const double more = offsets[t.pair[0]] - offsets[t.pair[1]];
            const double most = deficits.is_wide(t.pair[0]) || deficits.is_wide(t.pair[1]) ? wide : usual;
            t.offset = std::clamp(t.offset + more, -most, most);
        }
    });
}

}  // namespace cleft
