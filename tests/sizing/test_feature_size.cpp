// The feature size of shapes whose local thickness is known: balls, tori, sheets, rods, planes.
#include "sizing/feature_size.hpp"

#include "label_shapes.hpp"
#include "support/cmocka.hpp"

using namespace cleft;
using namespace sizing_test;

namespace
{

FeatureSizes features_of(const Labels& labels, int threads = 1)
{
    Run run;
    run.threads = threads;
    return local_feature_sizes(labels.labelling(), INFINITY, run);
}

// The size below which a share of the interface lies, for the interface voxels that `counts` picks.
double quantile(const Labels& labels, double share, const std::function<bool(const Vec3&)>& counts = nullptr)
{
    const FeatureSizes features = features_of(labels);
    std::vector<double> sizes;
    for (size_t n = 0; n < features.voxel.size(); ++n) {
        const auto at = VoxelCoordinates(labels.grid).of(features.voxel[n]);
        if (!counts || counts(labels.grid.centre(at[0], at[1], at[2])))
            sizes.push_back(features.size[n]);
    }
    std::sort(sizes.begin(), sizes.end());
    return sizes.empty() ? -1 : sizes[static_cast<size_t>(share * static_cast<double>(sizes.size() - 1))];
}

void of_a_ball_is_its_radius(void**)
{
    for (const double r : {3.0, 4.0, 5.0, 10.0, 20.0})
        for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(0.5, 0.5, 0.5), Vec3(0.13, -0.21, 0.4)}) {
            const auto n = static_cast<int32_t>(2 * r + 12);
            const Vec3 middle = Vec3::Constant(0.5 * n) + shift;
            const Labels labels = ball(grid_of(n, n, n), middle, r);
            assert_true(quantile(labels, 0.01) > (r < 5 ? 0.7 : r < 10 ? 0.8 : 0.9) * r);
            assert_true(quantile(labels, 0.5) > (r < 10 ? 0.85 : 0.95) * r);
            assert_true(quantile(labels, 0.99) < (r < 10 ? 1.3 : 1.1) * r);
        }
}

void of_small_balls_is_never_missed(void**)
{
    for (double r = 0.7; r < 4; r += 0.1)
        for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(0.5, 0.5, 0.5), Vec3(0.5, 0, 0), Vec3(0.13, -0.21, 0.4)}) {
            const Labels labels = ball(grid_of(16, 16, 16), Vec3(8, 8, 8) + shift, r);
            if (std::find(labels.values.begin(), labels.values.end(), 1) == labels.values.end())
                continue;
            assert_true(quantile(labels, 1) < 1.7 * r + 0.7);
        }
}

void scales_with_the_spacing(void**)
{
    const double r = 10;
    for (const double unit : {1e-6, 1e6}) {
        const Labels labels = ball(grid_of(32, 32, 32, Vec3::Constant(unit)), Vec3::Constant(16 * unit), r * unit);
        assert_true(quantile(labels, 0.01) > 0.9 * r * unit);
        assert_true(quantile(labels, 0.99) < 1.1 * r * unit);
    }
}

void of_a_ball_in_long_voxels(void**)
{
    const double r = 20;
    const Labels labels = ball(grid_of(96, 96, 16, {0.5, 0.5, 3}), Vec3(24.1, 23.8, 24.3), r);
    assert_true(quantile(labels, 0.01) > 0.75 * r);
    assert_true(quantile(labels, 0.5) > 0.85 * r);
    assert_true(quantile(labels, 0.99) < 1.25 * r);
}

void of_a_torus_is_the_radius_of_its_tube(void**)
{
    const Labels labels = labels_from(grid_of(52, 52, 20), [](const Vec3& x) {
        const double ring = std::hypot(x[0] - 26.1, x[1] - 25.9) - 18;
        return std::hypot(ring, x[2] - 10.2) < 6 ? 1 : 0;
    });
    assert_true(quantile(labels, 0.01) > 0.8 * 6);
    assert_true(quantile(labels, 0.5) > 0.93 * 6);
    assert_true(quantile(labels, 0.99) < 1.25 * 6);
}

void between_near_balls_is_half_their_distance(void**)
{
    const Vec3 a(24, 24, 24), b(67, 24, 24);  // 3 apart
    const Labels labels = labels_from(grid_of(91, 48, 48), [&](const Vec3& x) {
        return (x - a).norm() < 20 ? 1 : (x - b).norm() < 20 ? 2 : 0;
    });
    const auto between = [](const Vec3& x) {
        return std::abs(x[0] - 45.5) < 2.5 && (x - Vec3(x[0], 24, 24)).norm() < 4;
    };
    assert_true(quantile(labels, 0.05, between) > 1.0);
    assert_true(quantile(labels, 0.95, between) < 2.5);
    const auto far = [](const Vec3& x) { return x[0] < 24; };
    assert_true(quantile(labels, 0.05, far) > 0.85 * 20);
}

void of_sheets_is_half_their_thickness(void**)
{
    for (int axis = 0; axis < 3; ++axis)
        for (int thick = 1; thick <= 9; ++thick) {
            const Labels labels = labels_from(
                grid_of(24, 25, 26), [=](const Vec3& x) { return x[axis] > 8 && x[axis] < 8 + thick ? 1 : 0; });
            assert_true(quantile(labels, 0) > 0.49 * thick);
            assert_true(quantile(labels, 0.9) < 0.51 * thick);
            assert_true(quantile(labels, 1) < 0.62 * thick);  // next to the faces of the box
        }
    const Vec3 normal = Vec3(0.1, 0.2, 1).normalized();  // with stairs
    const auto inside = [](const Vec3& x) { return (x - Vec3::Constant(20)).cwiseAbs().maxCoeff() < 14; };
    for (const double thick : {2.0, 4.0, 8.0}) {
        const Labels labels = labels_from(grid_of(40, 40, 40), [=](const Vec3& x) {
            return std::abs(normal.dot(x - Vec3::Constant(20))) < 0.5 * thick ? 1 : 0;
        });
        assert_true(quantile(labels, 0.01, inside) > 0.65 * 0.5 * thick);
        assert_true(quantile(labels, 0.5, inside) > 0.9 * 0.5 * thick);
        assert_true(quantile(labels, 0.99, inside) < 1.5 * 0.5 * thick);
    }
}

void of_rods_is_about_their_radius(void**)
{
    for (int thick = 1; thick <= 7; ++thick) {
        const Labels labels = labels_from(grid_of(20, 21, 22), [=](const Vec3& x) {
            return x[0] > 6 && x[0] < 6 + thick && x[2] > 7 && x[2] < 7 + thick ? 1 : 0;
        });
        assert_true(quantile(labels, 0) > 0.2 * thick);
        assert_true(quantile(labels, 1) < 0.8 * thick);
    }
}

void of_planes_is_infinite(void**)
{
    for (const Vec3& spacing : {Vec3(1, 1, 1), Vec3(0.5, 0.5, 3)})
        for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(0.1, 0.2, 1), Vec3(1, 1.2, 0.9), Vec3(0.03, 0.02, 1)}) {
            const Vec3 n = Vec3::Constant(36).cwiseQuotient(spacing);
            const Grid grid =
                grid_of(static_cast<int32_t>(n[0]), static_cast<int32_t>(n[1]), static_cast<int32_t>(n[2]), spacing);
            const Labels labels =
                labels_from(grid, [=](const Vec3& x) { return normal.dot(x - Vec3::Constant(18)) < 0 ? 0 : 1; });
            assert_true(quantile(labels, 0) == INFINITY);
        }
}

void of_one_label_has_no_interface(void**)
{
    const FeatureSizes features = features_of(labels_from(grid_of(9, 8, 7), [](const Vec3&) { return 4; }));
    assert_true(features.voxel.empty() && features.size.empty());
}

void holds_every_interface_voxel_once(void**)
{
    const Labels labels = noise(grid_of(19, 18, 17), 5, 1);
    const FeatureSizes features = features_of(labels);
    assert_true(std::is_sorted(features.voxel.begin(), features.voxel.end()));
    size_t n = 0;
    const auto value = [&](int32_t i, int32_t j, int32_t k) {
        return labels.values[static_cast<size_t>(labels.grid.index(i, j, k))];
    };
    for (int32_t k = 0; k < 17; ++k)
        for (int32_t j = 0; j < 18; ++j)
            for (int32_t i = 0; i < 19; ++i) {
                const Material own = value(i, j, k);
                const bool interface = (i > 0 && value(i - 1, j, k) != own) || (i < 18 && value(i + 1, j, k) != own) ||
                                       (j > 0 && value(i, j - 1, k) != own) || (j < 17 && value(i, j + 1, k) != own) ||
                                       (k > 0 && value(i, j, k - 1) != own) || (k < 16 && value(i, j, k + 1) != own);
                if (!interface)
                    continue;
                assert_true(n < features.voxel.size());
                assert_int_equal(features.voxel[n], labels.grid.index(i, j, k));
                assert_true(features.size[n] >= 0);
                ++n;
            }
    assert_int_equal(n, features.voxel.size());
}

void does_not_depend_on_threads(void**)
{
    for (const Labels& labels : {ragged_cells(grid_of(60, 50, 40), 12, 2.0, 3), noise(grid_of(40, 30, 20), 3, 4),
                                 ragged_cells(grid_of(60, 50, 1), 12, 2.0, 5)}) {
        const FeatureSizes one = features_of(labels, 1);
        const FeatureSizes two = features_of(labels, 2);
        assert_true(one.voxel == two.voxel);
        assert_true(one.size == two.size);
        assert_int_equal(one.medial_voxels, two.medial_voxels);
    }
}

// The part of a volume that is looked at holds all that matters: near parts, and others far from them.
void up_to_the_greatest_are_the_same(void**)
{
    const Grid grid = grid_of(90, 80, 70, {1, 1.2, 0.7});
    const Labels labels = labels_from(grid, [](const Vec3& x) {
        return (x - Vec3(12, 12, 10)).norm() < 5   ? 1
               : (x - Vec3(60, 60, 30)).norm() < 9 ? 2
               : (x - Vec3(80, 12, 40)).norm() < 3 ? 3
                                                   : 0;
    });
    const FeatureSizes all = features_of(labels);
    for (const double most : {2.0, 6.0, 12.0, 30.0}) {
        const FeatureSizes some = local_feature_sizes(labels.labelling(), most, Run());
        assert_true(some.voxel == all.voxel);
        for (size_t n = 0; n < all.size.size(); ++n)
            assert_true(some.size[n] == all.size[n] || std::min(some.size[n], all.size[n]) > most);
    }
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(of_a_ball_is_its_radius),
        cmocka_unit_test(up_to_the_greatest_are_the_same),
        cmocka_unit_test(of_small_balls_is_never_missed),
        cmocka_unit_test(scales_with_the_spacing),
        cmocka_unit_test(of_a_ball_in_long_voxels),
        cmocka_unit_test(of_a_torus_is_the_radius_of_its_tube),
        cmocka_unit_test(between_near_balls_is_half_their_distance),
        cmocka_unit_test(of_sheets_is_half_their_thickness),
        cmocka_unit_test(of_rods_is_about_their_radius),
        cmocka_unit_test(of_planes_is_infinite),
        cmocka_unit_test(of_one_label_has_no_interface),
        cmocka_unit_test(holds_every_interface_voxel_once),
        cmocka_unit_test(does_not_depend_on_threads),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
