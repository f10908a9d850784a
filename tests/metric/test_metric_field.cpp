// Tensors and their logarithms, and metrics between voxel centres.
#include "metric/metric_field.hpp"
#include "support/cmocka.hpp"
#include "support/random.hpp"
#include "support/runs.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>

using namespace cleft;
using namespace cleft_test;

namespace
{

Tensor random_log(Random& random, double range)
{
    return {random.between(-range, range), random.between(-range, range), random.between(-range, range),
            random.between(-range, range), random.between(-range, range), random.between(-range, range)};
}

double difference(const Tensor& a, const Tensor& b) { return (a.matrix() - b.matrix()).norm(); }

}  // namespace

static void exponentials_and_logarithms_are_inverse(void**)
{
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Tensor log_before = random_log(random, 3);
        assert_true(difference(log(exp(log_before)), log_before) < 1e-5);
        // That of no trace keeps volumes.
        assert_float_equal(unit_exp(log_before).matrix().determinant(), 1, 1e-6);
    }
    assert_true(difference(exp(Tensor{}), {1, 0, 0, 1, 0, 1}) == 0);
}

static void eigenvalues_are_those_of_the_matrix(void**)
{
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const Tensor tensor = random_log(random, 5);
        const Eigen::SelfAdjointEigenSolver<Mat3> solver(tensor.matrix());
        assert_true((eigenvalues(tensor) - solver.eigenvalues()).norm() < 1e-6);
    }
    assert_true(eigenvalues({4, 0, 0, 4, 0, 4}) == Vec3(4, 4, 4));
    assert_true((eigenvalues({4, 0, 0, 1, 0, 4}) - Vec3(1, 4, 4)).norm() < 1e-7);
}

// Half way between sizes of 1 and 100 lies 10, and not their mean.
static void sizes_between_voxels_are_geometric_means(void**)
{
    MetricField field;
    field.grid.dims = {2, 1, 1};
    const float small = static_cast<float>(std::log(1.0)), large = static_cast<float>(std::log(1e-4));
    field.log = {{small, 0, 0, 0, 0, 0}, {large, 0, 0, 0, 0, 0}};
    assert_float_equal(exp(field.log_at({1, 0.5, 0.5})).xx, 1e-2, 1e-6);
    assert_float_equal(exp(field.log_at({0.2, 0.5, 0.5})).xx, 1, 1e-6);
    assert_float_equal(exp(field.log_at({5, 0.5, 0.5})).xx, 1e-4, 1e-8);
    assert_float_equal(greatest_stretch(field), 100, 1e-3);
}

// A measure that is not stretched has the greatest size in all directions.
static void stretches_begin_at_the_greatest_size(void**)
{
    MetricField field;
    field.grid.dims = {1, 1, 1};
    field.log = {{static_cast<float>(std::log(25.0)), 0, 0, static_cast<float>(std::log(4.0)), 0, 0}};
    const Vec3 middle(0.5, 0.5, 0.5);
    const Tensor round = exp(Measure{&field, 0}.log_at(middle));
    assert_true(difference(round, {1, 0, 0, 1, 0, 1}) < 1e-6);
    const Tensor half = exp(Measure{&field, 0.5}.log_at(middle));
    assert_true(difference(half, {5, 0, 0, 2, 0, 1}) < 1e-5);
    assert_true(difference(exp(Measure{&field, 1}.log_at(middle)), {25, 0, 0, 4, 0, 1}) < 1e-5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exponentials_and_logarithms_are_inverse),
        cmocka_unit_test(eigenvalues_are_those_of_the_matrix),
        cmocka_unit_test(sizes_between_voxels_are_geometric_means),
        cmocka_unit_test(stretches_begin_at_the_greatest_size),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
