// The gradation of metrics, and what it is made of.
#include "sizing/metric_gradation.hpp"
#include "support/cmocka.hpp"
#include "support/random.hpp"
#include "support/runs.hpp"

#include <cmath>

using namespace cleft;
using namespace cleft_test;

namespace
{

Tensor random_metric(Random& random)
{
    return exp({random.between(-2, 2), random.between(-2, 2), random.between(-2, 2), random.between(-2, 2),
                random.between(-2, 2), random.between(-2, 2)});
}

}  // namespace

// Nowhere less than either, and no greater than needed: in each common axis it equals one of the two.
static void intersections_are_the_least_that_cover_both(void**)
{
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        const Tensor a = random_metric(random), b = random_metric(random), both = intersection(a, b);
        assert_true(covers(1.0001 * both, a) && covers(1.0001 * both, b));
        // Where it touches one of them, a direction is left in which it is no greater.
        const double above_a = (both.matrix() - a.matrix()).determinant();
        const double above_b = (both.matrix() - b.matrix()).determinant();
        assert_true(std::min(std::abs(above_a), std::abs(above_b)) <= 1e-9 * std::pow(both.matrix().norm(), 3));
    }
    assert_true(covers({2, 0, 0, 2, 0, 2}, {1, 0, 0, 1, 0, 1}));
    assert_false(covers({2, 0, 0, 2, 0, 0.5}, {1, 0, 0, 1, 0, 1}));
    assert_false(covers({1, 2, 0, 1, 0, 1}, {0.1, 0, 0, 0.1, 0, 0.1}));
}

// From a small size in the middle, sizes grow by the gradation; those across and along keep their ratio.
static void sizes_grow_from_voxel_to_voxel(void**)
{
    Grid grid;
    grid.dims = {1, 1, 21};
    Array<Tensor> metric(21, Tensor{1e-4, 0, 0, 1e-4, 0, 1e-4});
    metric[10] = {1.0 / 64, 0, 0, 1.0 / 64, 0, 1};
    limit_metric_gradation(grid, 0.3, metric, Run{});
    for (int k = 0; k < 21; ++k) {
        const double distance = std::abs(k - 10);
        const double across = 1 / std::sqrt(metric[k].zz), along = 1 / std::sqrt(metric[k].xx);
        const double growth = 1 + 0.3 * distance;
        assert_true(std::abs(across - growth) < 0.02 * growth);
        assert_true(std::abs(along - 8 * growth) < 0.1 * growth);
    }
}

static void no_neighbour_asks_for_less_than_there_is(void**)
{
    Random random(5);
    Grid grid;
    grid.dims = {9, 8, 7};
    grid.spacing = Vec3(1, 0.5, 2);
    Array<Tensor> metric;
    for (int64_t v = 0; v < grid.size(); ++v)
        metric.push_back(random_metric(random));
    const Array<Tensor> before = metric;
    Array<Tensor> by_threads = metric;
    limit_metric_gradation(grid, 0.3, metric, Run{});
    limit_metric_gradation(grid, 0.3, by_threads, with_threads(3));
    const auto strides = grid.strides();
    for (int64_t v = 0; v < grid.size(); ++v) {
        assert_true(covers(1.001 * metric[v], before[v]));
        assert_true(metric[v].matrix() == by_threads[v].matrix());
        for (int axis = 0; axis < 3; ++axis) {
            if (v / strides[axis] % grid.dims[axis] == 0)
                continue;
            Vec3 step = Vec3::Zero();
            step[axis] = grid.spacing[axis];
            const Tensor& from = metric[v - strides[axis]];
            const double growth = 1 + 0.3 * std::sqrt(square(from, step));
            assert_true(covers(1.05 * metric[v], 1 / (growth * growth) * from));
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(intersections_are_the_least_that_cover_both),
        cmocka_unit_test(sizes_grow_from_voxel_to_voxel),
        cmocka_unit_test(no_neighbour_asks_for_less_than_there_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
