// Which pairs of materials share a face or an edge of voxels. The label report finds with it the contacts that only the
// mesh has.
#include "volume/voxel_contacts.hpp"

#include "base/parallel.hpp"
#include "base/shared_access.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// The pairs that were asked for, and which of them were seen. There can be 65,535 materials: no table of all pairs.
class Seen
{
public:
    // Marks in `seen`, which several threads may do.
    Seen(const Array<std::array<Material, 2>>& pairs, Array<uint8_t>& seen) : pairs_(pairs), seen_(seen)
    {
        CLEFT_ASSERT(std::is_sorted(pairs.begin(), pairs.end()));
    }

    void add(Material a, Material b)
    {
        CLEFT_ASSERT(a != b);
        // Few different pairs follow one another: most are among the last ones met.
        const std::array<Material, 2> pair{std::min(a, b), std::max(a, b)};
        std::array<Material, 2>& recent =
            recent_[(static_cast<uint32_t>(pair[0]) * 31u + static_cast<uint32_t>(pair[1])) % recent_.size()];
        if (recent == pair)
            return;
        recent = pair;
        const auto at = std::lower_bound(pairs_.begin(), pairs_.end(), pair);
        if (at != pairs_.end() && *at == pair)
            store_shared(seen_[at - pairs_.begin()], uint8_t{1});
    }

private:
    const Array<std::array<Material, 2>>& pairs_;
    Array<uint8_t>& seen_;
    std::array<std::array<Material, 2>, 1024> recent_{};  // two times material 0: no pair
};

// Most rows run side by side within one component: so many voxels are looked at together.
constexpr int64_t kContactsTogether = 16;

bool all_equal(const int32_t* here, const int32_t* there)
{
    int32_t different = 0;
    for (int64_t i = 0; i < kContactsTogether; ++i)
        different |= here[i] ^ there[i];
    return different == 0;
}

// The voxels of one row against those of another, `step` farther along x.
void add_rows(const VoxelComponents& components, int64_t row, int64_t other, int64_t count, int64_t step, Seen& seen)
{
    const int32_t* here = components.of_voxel.data() + row;
    const int32_t* there = components.of_voxel.data() + other + step;
    int32_t last_here = -1, last_there = -1;
    const int64_t end = std::min(count, count - step);
    for (int64_t i = std::max<int64_t>(0, -step); i < end; ++i) {
        while (i + kContactsTogether < end && all_equal(here + i, there + i))
            i += kContactsTogether;
        if (here[i] == there[i] || (here[i] == last_here && there[i] == last_there))
            continue;
        last_here = here[i];
        last_there = there[i];
        const Material a = components.material[last_here];
        const Material b = components.material[last_there];
        if (a != b)
            seen.add(a, b);
    }
}

// The nine neighbours over faces and edges that come after a voxel: one in its row, three in each of two rows next to
// it, and one in each of two rows across.
void add_neighbours_of_row(const Grid& grid, const VoxelComponents& components, int32_t j, int32_t k, Seen& seen)
{
    constexpr int32_t kBeside[2][2] = {{1, 0}, {0, 1}}, kAcross[2][2] = {{-1, 1}, {1, 1}};
    const int32_t nx = grid.dims[0];
    const int64_t row = grid.index(0, j, k);
    const auto add_beside = [&](const int32_t(&by)[2], int64_t reach) {
        if (j + by[0] < 0 || j + by[0] >= grid.dims[1] || k + by[1] >= grid.dims[2])
            return;
        for (int64_t step = -reach; step <= reach; ++step)
            add_rows(components, row, grid.index(0, j + by[0], k + by[1]), nx, step, seen);
    };
    add_rows(components, row, row, nx, 1, seen);
    for (size_t i = 0; i < 2; ++i) {
        add_beside(kBeside[i], 1);
        add_beside(kAcross[i], 0);
    }
}

}  // namespace

Array<uint8_t> voxels_touch(const Grid& grid, const VoxelComponents& components,
                            const Array<std::array<Material, 2>>& pairs, const Run& run)
{
    constexpr int64_t kPlanesAtOnce = 4;
    Array<uint8_t> touch(pairs.size(), 0);
    parallel_for(run, grid.dims[2], kPlanesAtOnce, [&](int64_t begin, int64_t end) {
        Seen seen(pairs, touch);
        for (auto k = static_cast<int32_t>(begin); k < end; ++k)
            for (int32_t j = 0; j < grid.dims[1]; ++j)
                add_neighbours_of_row(grid, components, j, k, seen);
    });
    return touch;
}

}  // namespace cleft
