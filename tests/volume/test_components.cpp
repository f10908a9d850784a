// Components of voxels against a flood fill.
#include "volume/voxel_components.hpp"

#include "support/cmocka.hpp"
#include "support/volumes.hpp"

using namespace cleft;
using namespace cleft_test;

namespace
{

Volume noise(const Dims& dims, int labels)
{
    Random random(7);
    const LabelVolume map =
        make_labels(dims, [&](int32_t, int32_t, int32_t) { return static_cast<int>(random.unit() * labels); });
    Grid grid;
    grid.dims = dims;
    return Volume::from_labels(VoxelType::uint8, map.voxels.data(), grid, 5, Run());
}

// The component of each voxel, numbered as they are met.
std::vector<int32_t> filled(const Volume& volume)
{
    const Grid& grid = volume.grid();
    const int64_t row = grid.dims[0], plane = row * grid.dims[1];
    std::vector<int32_t> component(static_cast<size_t>(grid.size()), -1);
    int32_t count = 0;
    for (int64_t start = 0; start < grid.size(); ++start) {
        std::vector<int64_t> stack;
        const auto enter = [&](int64_t v) {
            int32_t& c = component[static_cast<size_t>(v)];
            if (c >= 0 || volume.voxel_material(v) != volume.voxel_material(start))
                return;
            c = count;
            stack.push_back(v);
        };
        enter(start);
        const bool is_new = !stack.empty();
        while (!stack.empty()) {
            const int64_t v = stack.back(), x = v % row, y = v % plane / row, z = v / plane;
            stack.pop_back();
            if (x > 0)
                enter(v - 1);
            if (x + 1 < row)
                enter(v + 1);
            if (y > 0)
                enter(v - row);
            if (y + 1 < grid.dims[1])
                enter(v + row);
            if (z > 0)
                enter(v - plane);
            if (z + 1 < grid.dims[2])
                enter(v + plane);
        }
        count += is_new;
    }
    return component;
}

bool are_those_of_a_fill(const Volume& volume)
{
    const VoxelComponents found = voxel_components(volume, Run());
    std::vector<int64_t> voxels(found.voxels.size(), 0);
    for (size_t v = 0; v < found.of_voxel.size(); ++v) {
        const auto c = static_cast<size_t>(found.of_voxel[v]);
        ++voxels[c];
        if (found.material[c] != volume.voxel_material(static_cast<int64_t>(v)))
            return false;
    }
    return voxels == found.voxels && found.of_voxel == filled(volume);
}

void components_are_those_of_a_flood_fill(void**)
{
    for (const int labels : {1, 2, 3, 8})
        for (const Dims& dims :
             {Dims{1, 1, 1}, Dims{9, 1, 1}, Dims{1, 1, 9}, Dims{7, 1, 8}, Dims{1, 6, 5}, Dims{21, 17, 13}})
            assert_true(are_those_of_a_fill(noise(dims, labels)));
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {cmocka_unit_test(components_are_those_of_a_flood_fill)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
