// The nearest site of each voxel against a search of all sites.
#include "sizing/feature_transform.hpp"

#include "label_shapes.hpp"
#include "support/cmocka.hpp"

using namespace cleft;
using namespace sizing_test;

namespace
{

Array<int32_t> random_sites(const Grid& grid, double share, uint64_t seed)
{
    Random random(seed);
    Array<int32_t> sites(grid.size());
    for (size_t v = 0; v < sites.size(); ++v)
        sites[v] = random.uniform() < share ? static_cast<int32_t>(v) : -1;
    return sites;
}

Array<int32_t> transformed(const Grid& grid, Array<int32_t> sites, int threads)
{
    Run run;
    run.threads = threads;
    feature_transform(grid, INFINITY, sites, run);
    return sites;
}

Vec3 centre_of(const Grid& grid, int32_t voxel)
{
    const auto at = VoxelCoordinates(grid).of(voxel);
    return grid.centre(at[0], at[1], at[2]);
}

// The greatest excess, relative, of the distance to the site found over the distance to the nearest of all.
double worst_excess(const Grid& grid, const Array<int32_t>& sites, const Array<int32_t>& nearest)
{
    double worst = 0;
    for (int32_t v = 0; v < static_cast<int32_t>(nearest.size()); ++v) {
        const int32_t site = nearest[v];
        if (site < 0 || sites[site] != site)
            return INFINITY;
        const Vec3 x = centre_of(grid, v);
        double least = INFINITY;
        for (const int32_t s : sites)
            if (s >= 0)
                least = std::min(least, (centre_of(grid, s) - x).norm());
        const double found = (centre_of(grid, site) - x).norm();
        worst = std::max(worst, least > 0 ? found / least - 1 : found);
    }
    return worst;
}

void finds_the_nearest_site(void**)
{
    const Grid grids[] = {grid_of(17, 13, 11),
                          grid_of(17, 13, 11, {0.5, 0.5, 3}),
                          grid_of(35, 9, 8, {1e-6, 3e-6, 0.7e-6}),
                          grid_of(9, 20, 5, {1e6, 2.5e5, 1e6}),
                          grid_of(1, 23, 19),
                          grid_of(23, 1, 19, {1, 2, 3}),
                          grid_of(40, 23, 1, {3, 2, 1}),
                          grid_of(50, 1, 1),
                          grid_of(1, 1, 1)};
    for (const Grid& grid : grids)
        for (const double share : {0.5, 0.05, 0.003}) {
            auto sites = random_sites(grid, share, 7);
            sites.back() = static_cast<int32_t>(sites.size()) - 1;  // at least one
            assert_true(worst_excess(grid, sites, transformed(grid, sites, 1)) < 1e-12);
        }
}

void does_not_depend_on_threads(void**)
{
    const Grid grid = grid_of(70, 61, 53, {0.5, 0.5, 3});
    const auto sites = random_sites(grid, 0.01, 3);
    assert_true(transformed(grid, sites, 1) == transformed(grid, sites, 2));
    assert_true(transformed(grid, sites, 1) == transformed(grid, sites, 5));
}

void without_sites_finds_none(void**)
{
    const Grid grid = grid_of(6, 5, 4);
    const Array<int32_t> none(grid.size(), -1);
    assert_true(transformed(grid, none, 1) == none);
}

void coordinates_match_numbers(void**)
{
    const Grid grids[] = {grid_of(1290, 1290, 1290), grid_of(1, 46340, 46340), grid_of(2147483647, 1, 1),
                          grid_of(3, 1, 715827882), grid_of(7, 306783378, 1)};
    for (const Grid& grid : grids) {
        const VoxelCoordinates coordinates(grid);
        Random random(1);
        for (int n = 0; n < 100000; ++n) {
            // Ends of rows and planes are where rounding would show.
            int64_t voxel = static_cast<int64_t>(random.uniform() * static_cast<double>(grid.size()));
            if (n % 3 == 1)
                voxel -= voxel % grid.dims[0];
            if (n % 3 == 2)
                voxel = voxel - voxel % (int64_t{grid.dims[0]} * grid.dims[1]) - 1;
            if (voxel < 0)
                continue;
            const auto at = coordinates.of(static_cast<int32_t>(voxel));
            assert_int_equal(grid.index(at[0], at[1], at[2]), voxel);
            assert_true(at[0] >= 0 && at[0] < grid.dims[0] && at[1] >= 0 && at[1] < grid.dims[1]);
        }
    }
}

void finds_the_same_sites_within_a_reach(void**)
{
    for (const Grid& grid : {grid_of(40, 37, 33), grid_of(40, 37, 20, {0.5, 0.7, 3}), grid_of(50, 1, 70)})
        for (const double share : {0.02, 0.0005})
            for (const double reach : {0.4, 2.0, 5.3, 20.0, 100.0}) {
                const Array<int32_t> sites = random_sites(grid, share, 7);
                const Array<int32_t> all = transformed(grid, sites, 1);
                Array<int32_t> near = sites;
                Run run;
                run.threads = 2;
                feature_transform(grid, reach, near, run);
                for (int32_t v = 0; v < near.count(); ++v) {
                    const double distance =
                        all[v] < 0 ? INFINITY : (centre_of(grid, v) - centre_of(grid, all[v])).norm();
                    // At the very reach, rounding decides.
                    if (std::abs(distance - reach) > 1e-9 * reach)
                        assert_int_equal(near[v], distance < reach ? all[v] : -1);
                }
            }
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(finds_the_nearest_site),    cmocka_unit_test(does_not_depend_on_threads),
        cmocka_unit_test(without_sites_finds_none),  cmocka_unit_test(finds_the_same_sites_within_a_reach),
        cmocka_unit_test(coordinates_match_numbers),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
