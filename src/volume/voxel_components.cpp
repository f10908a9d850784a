// Connected pieces of equal voxels, by joining runs along x. The label report compares them with the pieces of the
// mesh.
#include "volume/voxel_components.hpp"

#include "base/disjoint_sets.hpp"
#include "base/stage.hpp"

namespace cleft
{

namespace
{

// The runs of one material along x, which are joined instead of voxels: there are far fewer of them.
VoxelComponents find_runs(const Volume& volume, const Run& run)
{
    const Grid& grid = volume.grid();
    VoxelComponents runs;
    const int32_t n = grid.dims[0];
    runs.of_voxel.reserve(grid.size());
    Array<Material> materials(n);
    for (int64_t v = 0; v < grid.size(); v += n) {
        if (v % (int64_t{n} * grid.dims[1]) == 0)
            run.report(static_cast<double>(v) / static_cast<double>(grid.size()));
        volume.voxel_materials(v, n, materials.data());
        for (int32_t begin = 0, end = 0; begin < n; begin = end) {
            while (end < n && materials[end] == materials[begin])
                ++end;
            runs.of_voxel.insert(runs.of_voxel.end(), to_size(end - begin), static_cast<int32_t>(runs.material.size()));
            runs.material.push_back(materials[begin]);
            runs.voxels.push_back(end - begin);
        }
    }
    return runs;
}

// Long runs are passed by so many voxels at a time.
constexpr int64_t kVoxelsTogether = 16;

bool all_equal(const int32_t* voxels, int32_t value)
{
    int32_t different = 0;
    for (int64_t i = 0; i < kVoxelsTogether; ++i)
        different |= voxels[i] ^ value;
    return different == 0;
}

// Joins runs of one material that touch across the rows `step` voxels before.
// Two long runs touch at many voxels; one join is enough, and the last pair is remembered for that.
void join_rows(const VoxelComponents& runs, int64_t first, int64_t count, int64_t step, DisjointSets& sets)
{
    const int32_t* const of_voxel = runs.of_voxel.data();
    int32_t last_here = -1, last_there = -1;
    for (int64_t v = first; v < first + count; ++v) {
        while (v + kVoxelsTogether < first + count && all_equal(of_voxel + v, last_here) &&
               all_equal(of_voxel + v - step, last_there))
            v += kVoxelsTogether;
        const int32_t here = of_voxel[v], there = of_voxel[v - step];
        if (here == last_here && there == last_there)
            continue;
        last_here = here;
        last_there = there;
        if (runs.material[here] == runs.material[there])
            sets.join(here, there);
    }
}

DisjointSets joined(const VoxelComponents& runs, const Grid& grid, const Run& run)
{
    DisjointSets sets(runs.material.size());
    const int64_t row = grid.dims[0], plane = row * grid.dims[1];
    for (int64_t first = 0; first < grid.size(); first += plane) {
        run.report(static_cast<double>(first) / static_cast<double>(grid.size()));
        join_rows(runs, first + row, plane - row, row, sets);
        if (first > 0)
            join_rows(runs, first, plane, plane, sets);
    }
    return sets;
}

}  // namespace

VoxelComponents voxel_components(const Volume& volume, const Run& run)
{
    Steps steps(run, {{nullptr, 1}, {nullptr, 1}});
    VoxelComponents runs = find_runs(volume, steps.next());
    const Array<int32_t> root = joined(runs, volume.grid(), steps.next()).take();
    // A root comes before the other runs of its component.
    VoxelComponents out;
    Array<int32_t> number(root.size());
    for (int32_t r = 0; r < root.count(); ++r) {
        const int32_t up = root[r];
        CLEFT_ASSERT(up <= r);
        if (up == r) {
            number[r] = static_cast<int32_t>(out.material.size());
            out.material.push_back(runs.material[r]);
            out.voxels.push_back(0);
        }
        number[r] = number[up];
        out.voxels[number[r]] += runs.voxels[r];
    }
    out.of_voxel = std::move(runs.of_voxel);
    for (int32_t& r : out.of_voxel)
        r = number[r];
    return out;
}

}  // namespace cleft
