// Looks at the corners of a tetrahedron and at two places on each edge.
#include "pipeline/crossings.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// So many labels have a table of 16 MB. More are those of grains and of single voxels, of which most neighbours touch.
constexpr int64_t kMostInTable = 4096;

// Which pairs of materials share a face of voxels.
Array<uint8_t> touching_pairs(const Volume& volume, const Run& run)
{
    const int64_t n = volume.material_count();
    if (n > kMostInTable)
        return {};
    Array<uint8_t> touch(n * n, 0);
    const Grid& grid = volume.grid();
    const FixedArray<int64_t, 3> stride = {1, grid.dims[0], int64_t{grid.dims[0]} * grid.dims[1]};
    int64_t v = 0;
    for (int32_t k = 0; k < grid.dims[2]; ++k)
        for (int32_t j = 0; j < grid.dims[1]; ++j)
            for (int32_t i = 0; i < grid.dims[0]; ++i, ++v) {
                run.check_at(v, 1 << 20);
                const Material here = volume.voxel_material(v);
                const FixedArray<int32_t, 3> at = {i, j, k};
                for (int axis = 0; axis < 3; ++axis)
                    if (at[axis] + 1 < grid.dims[axis]) {
                        const Material next = volume.voxel_material(v + stride[axis]);
                        touch[n * here + next] = touch[n * next + here] = 1;
                    }
            }
    return touch;
}

}  // namespace

CrossingCounter::CrossingCounter(const Volume& volume, const Run& run)
    : volume_(volume), touch_(touching_pairs(volume, run))
{
}

bool CrossingCounter::touch(Material a, Material b) const
{
    return a == b || touch_.empty() || touch_[int64_t{volume_.material_count()} * a + b] != 0;
}

bool CrossingCounter::has_another_between(const Vec3& a, const Vec3& b, Material of_a, Material of_b) const
{
    // Thinner parts between them are missed now and then, as they are by the mesh.
    for (const double share : {1.0 / 3, 2.0 / 3}) {
        const Material m = volume_.material_at(a + share * (b - a));
        if (m != of_a && m != of_b)
            return true;
    }
    return false;
}

// A vertex that snaps would pull both sides of a thin part onto itself, which snapping avoids. Is a corner the only one
// of its material, and the place as far behind it not of that material either?
bool CrossingCounter::has_one_alone(const std::array<Vec3, 4>& corners, const std::array<Material, 4>& materials) const
{
    for (size_t i = 0; i < 4; ++i) {
        const size_t a = (i + 1) % 4, b = (i + 2) % 4, c = (i + 3) % 4;
        if (materials[i] == materials[a] || materials[a] != materials[b] || materials[a] != materials[c])
            continue;
        const Vec3 behind = 2 * corners[i] - (corners[a] + corners[b] + corners[c]) / 3;
        return volume_.material_at(behind) != materials[i];
    }
    return false;
}

Crossings CrossingCounter::crossings(const std::array<Vec3, 4>& corners) const
{
    std::array<Material, 4> materials{};
    for (size_t i = 0; i < 4; ++i)
        materials[i] = volume_.material_at(corners[i]);
    Crossings out;
    out.tets = 1;
    int cut = 0, apart = 0;
    for (size_t i = 0; i < 4; ++i)
        for (size_t j = i + 1; j < 4; ++j) {
            const Material a = materials[i], b = materials[j];
            out.several += has_another_between(corners[i], corners[j], a, b) ? 1.0 / 6 : 0;
            cut += a != b ? 1 : 0;
            apart += touch(a, b) ? 0 : 1;
        }
    out.cut = cut / 6.0;
    out.apart = apart / 6.0;
    out.alone = has_one_alone(corners, materials) ? 1 : 0;
    std::sort(materials.begin(), materials.end());
    out.materials[std::unique(materials.begin(), materials.end()) - materials.begin() - 1] = 1;
    return out;
}

}  // namespace cleft
