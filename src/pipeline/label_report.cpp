#include "pipeline/label_report.hpp"

#include "base/disjoint_sets.hpp"
#include "mesh/finish.hpp"
#include "mesh/quality.hpp"

#include <algorithm>
#include <cstdlib>

namespace cleft
{

namespace
{

// The component, over faces, that each voxel is in: named by its least voxel.
std::vector<int32_t> voxel_components(const Volume& volume, const Run& run)
{
    const Grid& grid = volume.grid();
    DisjointSets sets(static_cast<size_t>(grid.size()));
    const int64_t step[3] = {1, grid.dims[0], int64_t{grid.dims[0]} * grid.dims[1]};
    int64_t v = 0;
    for (int32_t k = 0; k < grid.dims[2]; ++k) {
        run.report(k / static_cast<double>(grid.dims[2]), "counting components");
        for (int32_t j = 0; j < grid.dims[1]; ++j)
            for (int32_t i = 0; i < grid.dims[0]; ++i, ++v) {
                const int32_t at[3] = {i, j, k};
                for (int axis = 0; axis < 3; ++axis) {
                    const int64_t w = v - step[axis];
                    if (at[axis] != 0 && volume.voxel_material(v) == volume.voxel_material(w))
                        sets.join(static_cast<int32_t>(v), static_cast<int32_t>(w));
                }
            }
    }
    return sets.take();
}

int64_t voxel_of(const Grid& grid, const Vec3& x)
{
    int32_t at[3];
    for (int axis = 0; axis < 3; ++axis) {
        const int32_t last = grid.dims[static_cast<size_t>(axis)] - 1;
        at[axis] = std::clamp(static_cast<int32_t>(x[axis] / grid.spacing[axis]), 0, last);
    }
    return grid.index(at[0], at[1], at[2]);
}

// What a component of voxels and a connected part of the mesh have in common.
struct Shared {
    int32_t component, part;
    double volume;
};

// By component (at its least voxel): in how many parts of the mesh it is, small ones not counted.
std::vector<uint8_t> parts_of_components(std::vector<Shared>& shared, size_t voxels, double least)
{
    std::sort(shared.begin(), shared.end(), [](const Shared& a, const Shared& b) {
        return a.component != b.component ? a.component < b.component : a.part < b.part;
    });
    std::vector<uint8_t> parts(voxels, 0);
    for (auto first = shared.begin(); first != shared.end();) {
        double volume = 0;
        auto last = first;
        for (; last != shared.end() && last->component == first->component && last->part == first->part; ++last)
            volume += last->volume;
        uint8_t& count = parts[static_cast<size_t>(first->component)];
        count = static_cast<uint8_t>(count + (volume >= least && count < 2));
        first = last;
    }
    return parts;
}

}  // namespace

std::vector<LabelRow> label_report(const Volume& volume, const LabelledMesh& mesh, const Run& run)
{
    const Grid& grid = volume.grid();
    const Material count = volume.material_count();
    std::vector<LabelRow> rows(static_cast<size_t>(count));
    const std::vector<int64_t> voxels = volume.voxel_counts();
    const std::vector<double> volumes = material_volumes(mesh, count);
    const std::vector<int32_t> part = part_of_tets(mesh, run);
    for (size_t m = 0; m < rows.size(); ++m) {
        rows[m].label = volume.labels()[m];
        rows[m].voxels = voxels[m];
        rows[m].voxel_volume = static_cast<double>(voxels[m]) * grid.spacing.prod();
        rows[m].mesh_volume = volumes[m];
    }

    const std::vector<int32_t> roots = voxel_components(volume, run);
    std::vector<int32_t> sizes(roots.size(), 0);  // at each root: voxels; made negative when a tetrahedron lies in it
    for (const int32_t r : roots)
        ++sizes[static_cast<size_t>(r)];
    std::vector<Shared> shared;
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        const Tet& tet = mesh.tets[t];
        const auto point = [&](size_t i) -> const Vec3& { return mesh.points[static_cast<size_t>(tet[i])]; };
        const int64_t voxel = voxel_of(grid, (point(0) + point(1) + point(2) + point(3)) / 4);
        LabelRow& row = rows[static_cast<size_t>(mesh.material[t])];
        ++row.tets;
        row.mesh_components += part[t] == static_cast<int32_t>(t);
        if (volume.voxel_material(voxel) != mesh.material[t])
            continue;
        const int32_t component = roots[static_cast<size_t>(voxel)];
        int32_t& size = sizes[static_cast<size_t>(component)];
        size = -std::abs(size);
        if (-size > kLargeComponent)
            shared.push_back({component, part[t], orient(point(0), point(1), point(2), point(3)) / 6});
    }
    const std::vector<uint8_t> in_parts = parts_of_components(shared, roots.size(), kLeastPart * grid.spacing.prod());
    for (size_t v = 0; v < roots.size(); ++v) {
        if (roots[v] != static_cast<int32_t>(v))
            continue;
        LabelRow& row = rows[static_cast<size_t>(volume.voxel_material(static_cast<int64_t>(v)))];
        ++row.voxel_components;
        if (std::abs(sizes[v]) > kLargeComponent) {
            ++row.large_components;
            row.large_components_lost += sizes[v] > 0;
            row.large_components_broken += in_parts[v] > 1;
        }
    }
    return rows;
}

}  // namespace cleft
