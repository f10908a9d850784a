// The gradient-limited field against its definition: the lower envelope of cones on all values.
#include "sizing/gradient_limit.hpp"

#include "label_shapes.hpp"
#include "lipschitz.hpp"
#include "support/cmocka.hpp"

#include <cstring>

using namespace cleft;
using namespace sizing_test;

namespace
{

Array<float> limited(const Grid& grid, double gradation, Array<float> h, int threads = 1)
{
    Run run;
    run.threads = threads;
    limit_gradient(grid, gradation, h, run);
    return h;
}

// Values as of a segmented image: sizes of a wide range at a few voxels, the greatest elsewhere.
Array<float> scattered(const Grid& grid, double share, double least, double greatest, uint64_t seed)
{
    Random random(seed);
    Array<float> h(grid.size(), static_cast<float>(greatest));
    for (float& value : h)
        if (random.uniform() < share)
            value = static_cast<float>(least * std::pow(greatest / least, random.uniform()));
    return h;
}

// The exact envelope at one voxel.
double envelope(const Grid& grid, double gradation, const Array<float>& h, int32_t i, int32_t j, int32_t k)
{
    double least = INFINITY;
    size_t v = 0;
    for (int32_t z = 0; z < grid.dims[2]; ++z)
        for (int32_t y = 0; y < grid.dims[1]; ++y)
            for (int32_t x = 0; x < grid.dims[0]; ++x)
                least = std::min(least, h[v++] + gradation * (grid.centre(x, y, z) - grid.centre(i, j, k)).norm());
    return least;
}

struct Excess {
    double least = INFINITY, mean = 0, greatest = -INFINITY;
};

// Of limited values over the exact envelope, relative, at random voxels.
Excess excess(const Grid& grid, double gradation, const Array<float>& h, int samples)
{
    const auto result = limited(grid, gradation, h);
    Random random(11);
    Excess found;
    for (int n = 0; n < samples; ++n) {
        const auto at = VoxelCoordinates(grid).of(static_cast<int32_t>(random.next() % h.size()));
        const double exact = envelope(grid, gradation, h, at[0], at[1], at[2]);
        const double e = result[grid.index(at[0], at[1], at[2])] / exact - 1;
        found.least = std::min(found.least, e);
        found.greatest = std::max(found.greatest, e);
        found.mean += e / samples;
    }
    return found;
}

void is_the_lower_envelope_of_cones(void**)
{
    const Grid grids[] = {grid_of(40, 37, 33),  grid_of(40, 37, 20, {0.5, 0.5, 3}),
                          grid_of(90, 1, 70),   grid_of(1, 80, 60, {1, 0.3, 0.7}),
                          grid_of(120, 100, 1), grid_of(200, 1, 1)};
    for (const Grid& grid : grids)
        for (const double share : {0.3, 0.02, 0.0005})
            for (const double gradation : {0.05, 0.3, 1.0}) {
                const auto h = scattered(grid, share, 1, 30, 5);
                const Excess e = excess(grid, gradation, h, 60);
                assert_true(e.least > -1e-5);
                assert_true(e.mean < 1e-4);
                assert_true(e.greatest < 0.01);
            }
}

void is_lipschitz_between_neighbours(void**)
{
    const Grid grids[] = {grid_of(60, 50, 40),
                          grid_of(60, 50, 40, {0.5, 0.5, 3}),
                          grid_of(60, 50, 40, {1e-6, 1e-6, 2e-6}),
                          grid_of(60, 50, 40, {1e6, 2e6, 1e6}),
                          grid_of(120, 100, 1),
                          grid_of(1, 120, 100)};
    for (const Grid& grid : grids)
        for (const double share : {1.0, 0.1, 0.001})
            for (const double gradation : {0.01, 0.3, 2.0}) {
                const double unit = grid.spacing.minCoeff();
                const auto h = limited(grid, gradation, scattered(grid, share, unit, 300 * unit, 9));
                assert_true(worst_slope(grid, h) < gradation * (1 + 1e-4));
            }
}

void keeps_values_that_are_lipschitz(void**)
{
    const Grid grid = grid_of(30, 31, 32);
    const Array<float> constant(grid.size(), 2.5F);
    assert_true(limited(grid, 0.3, constant) == constant);
    const auto once = limited(grid, 0.3, scattered(grid, 0.01, 1, 30, 2));
    const auto twice = limited(grid, 0.3, once);
    for (size_t v = 0; v < once.size(); ++v)
        assert_true(std::abs(twice[v] - once[v]) <= 1e-5F * once[v]);
}

void never_falls_below_the_least_value(void**)
{
    const Grid grid = grid_of(60, 50, 40);
    const auto h = scattered(grid, 0.02, 1, 30, 4);
    const auto result = limited(grid, 0.3, h);
    assert_true(*std::min_element(result.begin(), result.end()) == *std::min_element(h.begin(), h.end()));
    for (size_t v = 0; v < h.size(); ++v)
        assert_true(result[v] <= h[v]);
}

void does_not_depend_on_threads(void**)
{
    for (const Grid& grid : {grid_of(70, 61, 53, {0.5, 0.5, 3}), grid_of(70, 61, 1), grid_of(1, 61, 53)}) {
        const auto h = scattered(grid, 0.01, 1, 30, 8);
        const auto one = limited(grid, 0.3, h, 1);
        for (const int threads : {2, 5})
            assert_memory_equal(limited(grid, 0.3, h, threads).data(), one.data(), one.size() * sizeof(float));
    }
}

void can_be_cancelled(void**)
{
    const Grid grid = grid_of(64, 64, 64);
    auto h = scattered(grid, 0.01, 1, 30, 8);
    Run run;
    run.threads = 2;
    int reports = 0;
    run.progress = [&](double, const char*) { return ++reports == 3; };
    cleft_status status = CLEFT_OK;
    try {
        limit_gradient(grid, 0.3, h, run);
    } catch (const Error& error) {
        status = error.status();
    }
    assert_int_equal(status, CLEFT_ERROR_CANCELLED);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(is_the_lower_envelope_of_cones),  cmocka_unit_test(is_lipschitz_between_neighbours),
        cmocka_unit_test(keeps_values_that_are_lipschitz), cmocka_unit_test(never_falls_below_the_least_value),
        cmocka_unit_test(does_not_depend_on_threads),      cmocka_unit_test(can_be_cancelled),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
