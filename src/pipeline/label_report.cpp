// Compares the labels of a mesh with those of its volume: volumes, pieces that are lost, broken or joined, and new
// contacts.
#include "pipeline/label_report.hpp"

#include "base/collect.hpp"
#include "base/shared_access.hpp"
#include "base/stage.hpp"
#include "mesh/materials.hpp"
#include "mesh/quality.hpp"
#include "pipeline/pipeline.hpp"
#include "volume/voxel_components.hpp"
#include "volume/voxel_contacts.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// The cast truncates; centroids lie in the box but for rounding, which the clamp takes care of.
int64_t voxel_of(const Grid& grid, const Vec3& x)
{
    int32_t at[3];
    for (int axis = 0; axis < 3; ++axis) {
        const int32_t last = grid.dims[axis] - 1;
        at[axis] = std::clamp(static_cast<int32_t>(x[axis] / grid.spacing[axis]), 0, last);
    }
    return grid.index(at[0], at[1], at[2]);
}

// What a component of voxels and a connected part of the mesh have in common.
struct Shared {
    int32_t component, part;
    double volume;
};

// Tetrahedra come along a curve through space: mostly one follows another of the same pair.
void add(Array<Shared>& shared, const Shared& next)
{
    if (!shared.empty() && shared.back().component == next.component && shared.back().part == next.part)
        shared.back().volume += next.volume;
    else
        shared.push_back(next);
}

// Each pair once, those of little volume left out, by component and then by part.
Array<Shared> summed(Array<Shared> shared, double least)
{
    std::sort(shared.begin(), shared.end(), [](const Shared& a, const Shared& b) {
        return a.component != b.component ? a.component < b.component : a.part < b.part;
    });
    Array<Shared> pairs;
    for (const Shared& next : shared)
        add(pairs, next);
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), [&](const Shared& s) { return s.volume < least; }),
                pairs.end());
    return pairs;
}

// By component: whether it is in several parts of the mesh.
Array<uint8_t> broken_components(const Array<Shared>& pairs, size_t components)
{
    Array<uint8_t> broken(components, 0);
    for (size_t i = 1; i < pairs.size(); ++i)
        if (pairs[i].component == pairs[i - 1].component)
            broken[pairs[i].component] = 1;
    return broken;
}

// By component: whether it shares a part of the mesh with another.
Array<uint8_t> joined_components(Array<Shared> pairs, size_t components)
{
    std::stable_sort(pairs.begin(), pairs.end(), [](const Shared& a, const Shared& b) { return a.part < b.part; });
    Array<uint8_t> joined(components, 0);
    for (size_t i = 1; i < pairs.size(); ++i)
        if (pairs[i].part == pairs[i - 1].part)
            joined[pairs[i].component] = joined[pairs[i - 1].component] = 1;
    return joined;
}

// Of the materials that meet in the mesh, those that do not in the voxels.
Array<LabelContact> new_contacts(const Volume& volume, const VoxelComponents& components, const Array<Border>& borders,
                                 const Run& run)
{
    const auto label = [&](Material m) { return volume.labels()[m]; };
    Array<std::array<Material, 2>> pairs;
    for (const Border& border : borders)
        pairs.push_back({border.first, border.second});
    const Array<uint8_t> touch = voxels_touch(volume.grid(), components, pairs, run);
    Array<LabelContact> contacts;
    for (size_t i = 0; i < borders.size(); ++i) {
        LabelContact contact{borders[i].first, borders[i].second, borders[i].triangles};
        if (label(contact.first) > label(contact.second))
            std::swap(contact.first, contact.second);
        if (touch[i] == 0)
            contacts.push_back(contact);
    }
    std::sort(contacts.begin(), contacts.end(), [&](const LabelContact& a, const LabelContact& b) {
        return a.first != b.first ? label(a.first) < label(b.first) : label(a.second) < label(b.second);
    });
    return contacts;
}

// Labels, voxels and volumes; the counts of tetrahedra and pieces are not in them yet.
Array<LabelRow> rows_of_labels(const Volume& volume, const LabelledMesh& mesh, const Run& run)
{
    const Array<int64_t>& voxels = volume.voxel_counts();
    const Array<double> volumes = material_volumes(mesh, volume.material_count(), run);
    Array<LabelRow> rows(volume.material_count());
    for (size_t m = 0; m < rows.size(); ++m) {
        rows[m].label = volume.labels()[m];
        rows[m].voxels = voxels[m];
        rows[m].voxel_volume = static_cast<double>(voxels[m]) * volume.grid().spacing.prod();
        rows[m].mesh_volume = volumes[m];
    }
    return rows;
}

// What the tetrahedra say of the components of the voxels.
struct MetComponents {
    Array<uint8_t> is_met;  // by component: by a tetrahedron in it
    Array<Shared> shared;   // of large ones: the volume in each part of the mesh
};

// Looks at the tetrahedra from `begin` on, beside other threads: all add to the same rows and marks.
void count_tets(const Grid& grid, const LabelledMesh& mesh, const Array<int32_t>& part,
                const VoxelComponents& components, int64_t begin, int64_t end, Array<LabelRow>& rows,
                MetComponents& met, Array<Shared>& shared)
{
    for (int64_t t = begin; t < end; ++t) {
        const Tet& tet = mesh.tets[t];
        const auto point = [&](size_t i) -> const Vec3& { return mesh.points[tet[i]]; };
        const int64_t voxel = voxel_of(grid, (point(0) + point(1) + point(2) + point(3)) / 4);
        LabelRow& row = rows[mesh.material[t]];
        add_shared(row.tets, int64_t{1});
        // A part is numbered by its first tetrahedron, so each is counted once.
        if (part[t] == t)
            add_shared(row.mesh_components, int64_t{1});
        const int32_t component = components.of_voxel[voxel];
        // A tetrahedron at an interface may have its centroid in a voxel of the other label, and says nothing about
        // either piece.
        if (components.material[component] != mesh.material[t])
            continue;
        store_shared(met.is_met[component], uint8_t{1});
        if (components.voxels[component] > kLargeComponent)
            add(shared, {component, part[t], orient(point(0), point(1), point(2), point(3)) / 6});
    }
}

MetComponents count_tets(const Grid& grid, const LabelledMesh& mesh, const Array<int32_t>& part,
                         const VoxelComponents& components, Array<LabelRow>& rows, const Run& run)
{
    constexpr int64_t kTetsAtOnce = 1 << 14;
    MetComponents met{Array<uint8_t>(components.voxels.size(), 0), {}};
    met.shared =
        collect<Shared>(run, mesh.tets.count(), kTetsAtOnce, [&](int64_t begin, int64_t end, Array<Shared>& shared) {
            count_tets(grid, mesh, part, components, begin, end, rows, met, shared);
        });
    return met;
}

void count_components(const Grid& grid, const VoxelComponents& components, MetComponents met, Array<LabelRow>& rows)
{
    const Array<Shared> pairs = summed(std::move(met.shared), kLeastPart * grid.spacing.prod());
    const Array<uint8_t> broken = broken_components(pairs, met.is_met.size());
    const Array<uint8_t> joined = joined_components(pairs, met.is_met.size());
    for (size_t c = 0; c < met.is_met.size(); ++c) {
        LabelRow& row = rows[components.material[c]];
        ++row.voxel_components;
        if (components.voxels[c] > kLargeComponent) {
            ++row.large_components;
            row.large_components_lost += met.is_met[c] == 0;
            row.large_components_broken += broken[c];
            row.large_components_joined += joined[c];
        }
    }
}

}  // namespace

LabelReport label_report(const Volume& volume, const LabelledMesh& mesh, const Run& run)
{
    Steps steps(run, {{"finding parts", 4}, {"counting components", 4}, {"looking for contacts", 2}});
    const MeshParts parts = mesh_parts(mesh, steps.next());
    const Run of_components = steps.next();
    const VoxelComponents components = voxel_components(volume, of_components);
    Array<LabelRow> rows = rows_of_labels(volume, mesh, of_components);
    count_components(volume.grid(), components,
                     count_tets(volume.grid(), mesh, parts.of_tet, components, rows, of_components), rows);
    return {std::move(rows), new_contacts(volume, components, parts.borders, steps.next())};
}

}  // namespace cleft
