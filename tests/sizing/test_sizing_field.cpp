// The sizing field: its bounds and gradation, each source of sizes, max_tets, and what is refused.
#include "sizing/compute.hpp"

#include "label_shapes.hpp"
#include "lipschitz.hpp"
#include "sizing/sizing_charge.hpp"
#include "support/cmocka.hpp"

#include <string>

using namespace cleft;
using namespace sizing_test;

namespace
{

SizingField field_of(const Labels& labels, const SizingOptions& options, int threads = 1)
{
    Run run;
    run.threads = threads;
    return compute_sizing(labels.labelling(), options, run);
}

cleft_status status_of(const SizingOptions& options)
{
    try {
        field_of(ball(grid_of(8, 8, 8), {4, 4, 4}, 2), options);
    } catch (const Error& error) {
        return error.status();
    }
    return CLEFT_OK;
}

void is_lipschitz_and_within_limits(void**)
{
    const Labels volumes[] = {noise(grid_of(24, 24, 24), 5, 1),
                              ragged_cells(grid_of(60, 50, 40), 10, 2.0, 2),
                              ragged_cells(grid_of(60, 50, 20, {0.5, 0.5, 3}), 10, 1.0, 3),
                              ball(grid_of(40, 40, 40), {20, 20, 20}, 10),
                              ragged_cells(grid_of(60, 50, 1), 10, 2.0, 4),
                              ragged_cells(grid_of(1, 50, 60), 10, 2.0, 5),
                              noise(grid_of(200, 1, 1), 2, 6)};
    for (const Labels& labels : volumes)
        for (const double gradation : {0.1, 0.3, 1.0}) {
            SizingOptions options;
            options.gradation = gradation;
            options.size_min = 0.75;
            options.size_max = 4;
            const SizingField field = field_of(labels, options);
            assert_true(field.gradation == gradation);
            assert_true(worst_slope(field.grid, field.h) < gradation * (1 + 1e-4));
            assert_true(field.range().least >= 0.75 && field.range().greatest <= 4);
        }
}

void of_one_label_is_the_greatest_size(void**)
{
    const auto one = [](const Vec3&) { return 3; };
    assert_true(field_of(labels_from(grid_of(20, 16, 12), one), {}).range().least == 5);
    assert_true(field_of(labels_from(grid_of(20, 16, 12), one), {}).range().greatest == 5);
    // A plate: no more than it is thick.
    assert_true(field_of(labels_from(grid_of(40, 40, 2), one), {}).range().greatest == 2);
    // Nor less than a voxel is long.
    assert_true(field_of(labels_from(grid_of(40, 40, 1, {1, 1, 0.01}), one), {}).range().greatest == 1);
    SizingOptions options;
    options.size_max = 7;
    assert_true(field_of(labels_from(grid_of(20, 16, 12), one), options).range().least == 7);
    options = {};
    options.size_min = 9;
    assert_true(field_of(labels_from(grid_of(20, 16, 12), one), options).range().least == 9);
    assert_true(field_of(labels_from(grid_of(1, 1, 1), one), {}).range().least == 1);
}

void follows_the_feature_size(void**)
{
    const Labels labels = ball(grid_of(60, 60, 60), {30, 30, 30}, 10);
    for (const double scale : {0.25, 0.5, 1.0}) {
        SizingOptions options;
        options.feature_scale = scale;
        const SizingField field = field_of(labels, options);
        const double at_interface = field.at({40, 30, 30});
        assert_true(at_interface > 0.85 * scale * 10 && at_interface < 1.1 * scale * 10);
        // Away from it the size grows by the gradation, or by what the box allows.
        const double far = field.at({55, 30, 30});
        assert_true(far <= at_interface + 0.3 * 15 + 1e-6);
        assert_true(far >= std::min(15.0, at_interface + 0.3 * 15) - 0.7);
    }
}

void size_min_holds_for_features(void**)
{
    const Labels labels = labels_from(grid_of(20, 20, 20), [](const Vec3& x) { return x[2] > 9 && x[2] < 10 ? 1 : 0; });
    assert_true(field_of(labels, {}).range().least ==
                1);  // half a voxel thick on either side, but no less than a voxel
    SizingOptions options;
    options.size_min = 2.5;
    assert_true(field_of(labels, options).range().least == 2.5);
    options.size_min = 0.25;
    assert_true(std::abs(field_of(labels, options).range().least - 0.5) < 1e-6);
}

void explicit_sizes_go_below_a_voxel_unless_size_min_is_given(void**)
{
    const Labels labels = ball(grid_of(30, 30, 30), {15, 15, 15}, 8);
    Array<float> user(labels.values.size(), 100.0F);
    user[labels.grid.index(2, 3, 4)] = 0.3F;
    SizingOptions by_interface, by_label, by_user;
    by_interface.interface_size = 0.3;
    by_label.material_sizes = {0, 0.3};
    by_user.user = user.data();
    for (SizingOptions options : {by_interface, by_label, by_user}) {
        assert_true(field_of(labels, options).range().least == static_cast<double>(0.3F));
        options.size_min = 0.6;
        assert_true(field_of(labels, options).range().least == static_cast<double>(0.6F));
    }
}

void sizes_of_materials_hold_inside_and_fade_outside(void**)
{
    const Labels labels = ball(grid_of(40, 40, 40), {20, 20, 20}, 10);
    SizingOptions options;
    options.material_sizes = {0, 1.5};
    const SizingField field = field_of(labels, options);
    for (size_t v = 0; v < labels.values.size(); ++v)
        if (labels.values[v] == 1)
            assert_true(field.h[v] == 1.5F);
    assert_true(std::abs(field.at({20, 20, 35}) - (1.5 + 0.3 * 5)) < 0.2);
    assert_true(worst_slope(field.grid, field.h) < 0.3 * (1 + 1e-4));
}

void interface_size_holds_at_the_interface(void**)
{
    const Labels labels = ball(grid_of(40, 40, 40), {20, 20, 20}, 10);
    SizingOptions options;
    options.interface_size = 1.25;
    const SizingField field = field_of(labels, options);
    assert_true(std::abs(field.at({30, 20, 20}) - 1.25) < 0.01);
    const double inside = field.at({20, 20, 20});
    assert_true(inside > 1.25 + 0.3 * 8 && inside < 1.25 + 0.3 * 10);
    assert_true(field.range().least == 1.25);
    options.size = 3;  // with a constant size elsewhere
    assert_true(field_of(labels, options).range().least == 1.25);
    assert_true(field_of(labels, options).range().greatest == 3);
}

void a_users_field_is_combined_by_minimum(void**)
{
    const Labels labels = ball(grid_of(40, 40, 40), {20, 20, 20}, 10);
    const SizingField without = field_of(labels, {});
    Array<float> user(labels.values.size(), 1e6F);
    SizingOptions options;
    options.user = user.data();
    assert_true(field_of(labels, options).h == without.h);
    user[labels.grid.index(5, 5, 5)] = 1.0F;
    const SizingField with = field_of(labels, options);
    assert_true(with.h[labels.grid.index(5, 5, 5)] == 1.0F);
    for (size_t v = 0; v < with.h.size(); ++v)
        assert_true(with.h[v] <= without.h[v] * (1 + 1e-5F));
    for (const float bad : {0.0F, -1.0F, NAN, INFINITY}) {
        user[77] = bad;
        assert_int_equal(status_of(SizingOptions{}), CLEFT_OK);
        std::string sentence;
        try {
            field_of(labels, options);
        } catch (const Error& error) {
            sentence = error.what();
        }
        assert_true(sentence.find("38th along x, the 2nd along y and the 1st along z") != std::string::npos);
    }
}

void a_constant_size_ignores_features(void**)
{
    SizingOptions options;
    options.size = 2.25;
    const SizingField field = field_of(noise(grid_of(12, 12, 12), 3, 1), options);
    assert_true(field.range().least == 2.25 && field.range().greatest == 2.25);
}

void refuses_bad_options(void**)
{
    SizingOptions options;
    options.size_min = -1;
    assert_int_equal(status_of(options), CLEFT_ERROR_OPTION);
    options = {};
    options.size_max = NAN;
    assert_int_equal(status_of(options), CLEFT_ERROR_OPTION);
    options = {};
    options.size_min = 3;
    options.size_max = 2;
    assert_int_equal(status_of(options), CLEFT_ERROR_OPTION);
    options = {};
    options.gradation = 0;
    assert_int_equal(status_of(options), CLEFT_ERROR_OPTION);
    options = {};
    options.feature_scale = INFINITY;
    assert_int_equal(status_of(options), CLEFT_ERROR_OPTION);
    options = {};
    options.material_sizes = {0, NAN};
    assert_int_equal(status_of(options), CLEFT_ERROR_OPTION);
}

void at_interpolates_and_clamps(void**)
{
    SizingField field{grid_of(4, 3, 2, {1, 2, 4}), Array<float>(24), 0.3};
    const auto linear = [](const Vec3& x) { return 1 + 0.5 * x[0] + 0.25 * x[1] + 0.125 * x[2]; };
    for (int32_t k = 0; k < 2; ++k)
        for (int32_t j = 0; j < 3; ++j)
            for (int32_t i = 0; i < 4; ++i)
                field.h[field.grid.index(i, j, k)] = static_cast<float>(linear(field.grid.centre(i, j, k)));
    Random random(1);
    for (int n = 0; n < 1000; ++n) {
        const double a = random.uniform(), b = random.uniform(), c = random.uniform();
        const Vec3 x = Vec3(2 * a - 0.5, 2 * b - 0.5, 2 * c - 0.5).cwiseProduct(field.grid.extent());
        const Vec3 low = 0.5 * field.grid.spacing;
        const Vec3 nearest = x.cwiseMax(low).cwiseMin(field.grid.extent() - low);
        assert_true(std::abs(field.at(x) - linear(nearest)) < 1e-6);
    }
    const SizingField flat = constant_sizing(grid_of(1, 5, 1), 2);
    assert_true(flat.at({0.3, 4.9, 7}) == 2);
    assert_true(flat.at({NAN, 1, 1}) == 2);
}

void charge_scales_as_the_inverse_cube(void**)
{
    SizingField field = field_of(ragged_cells(grid_of(40, 40, 40, {0.5, 1, 2}), 8, 2.0, 2), {});
    const double charge = sizing_charge(field);
    const double least = field.range().least;
    scale_sizing(field, 0.7, Run());
    assert_true(std::abs(field.range().least / 0.7 / least - 1) < 1e-6);
    assert_true(std::abs(sizing_charge(field) * 0.7 * 0.7 * 0.7 / charge - 1) < 1e-5);
    assert_true(std::abs(sizing_charge(constant_sizing(grid_of(10, 20, 30, {1, 2, 3}), 2)) - 36000.0 / 8) < 1e-6);
}

// A coarser field is what coarser features would have given: it does not grow faster.
void scaling_keeps_the_gradation(void**)
{
    const Labels labels = ball(grid_of(40, 40, 40), {20, 20, 20}, 10);
    SizingOptions options;
    options.size_max = 5;
    SizingField field = field_of(labels, options);
    scale_sizing(field, 3, Run());
    assert_true(field.gradation == options.gradation);
    assert_true(worst_slope(field.grid, field.h) < options.gradation * (1 + 1e-4));
    options.feature_scale = 3;
    options.size_min = 3;
    options.size_max = 15;
    const SizingField coarse = field_of(labels, options);
    for (size_t v = 0; v < field.h.size(); ++v)
        assert_true(std::abs(field.h[v] - coarse.h[v]) < 1e-3F * coarse.h[v]);
}

void no_field_is_scaled_by_what_is_no_factor(void**)
{
    SizingField field = constant_sizing(grid_of(2, 2, 2), 3);
    for (const double factor : {0.0, -1.0, double{NAN}, HUGE_VAL}) {
        cleft_status status = CLEFT_OK;
        try {
            scale_sizing(field, factor, Run());
        } catch (const Error& error) {
            status = error.status();
        }
        assert_int_equal(status, CLEFT_ERROR_ARGUMENT);
        assert_true(field.range().least == 3 && field.range().greatest == 3);
    }
}

void too_many_tets_raise_the_least_size(void**)
{
    const Labels labels = noise(grid_of(30, 30, 30), 3, 4);
    SizingOptions options;
    const double asked = expected_particle_tets(field_of(labels, options));
    options.max_tets = 0.1 * asked;
    const SizingField field = field_of(labels, options);
    const double kept = expected_particle_tets(field);
    assert_true(kept < 1.02 * options.max_tets && kept > 0.6 * options.max_tets);
    assert_true(worst_slope(field.grid, field.h) < options.gradation * (1 + 1e-4));
    options.max_tets = 2 * asked;  // enough: nothing changes
    assert_true(expected_particle_tets(field_of(labels, options)) == asked);
    options.max_tets = 0.1 * asked;
    options.size_min = 1;  // what the user says is kept to
    assert_true(expected_particle_tets(field_of(labels, options)) == asked);
}

void values_are_taken_as_they_are(void**)
{
    const Grid grid = grid_of(2, 2, 2);
    Array<double> values{1, 2, 3, 4, 5, 6, 7, 8};
    const SizingField field = sizing_from_values(grid, values.data());
    for (size_t v = 0; v < values.size(); ++v)
        assert_true(field.h[v] == static_cast<float>(values[v]));
    values[3] = 1e300;  // not a float
    std::string sentence;
    try {
        sizing_from_values(grid, values.data());
    } catch (const Error& error) {
        sentence = error.what();
    }
    assert_true(sentence.find("2nd along x, the 2nd along y and the 1st along z") != std::string::npos);
}

void does_not_depend_on_threads(void**)
{
    SizingOptions options;
    options.material_sizes.assign(12, 0);
    options.material_sizes[3] = 1.5;
    options.interface_size = 2;
    for (const Labels& labels :
         {ragged_cells(grid_of(60, 50, 40, {0.5, 0.5, 3}), 12, 2.0, 3), noise(grid_of(40, 30, 20), 5, 4)})
        for (const int threads : {2, 3})
            assert_true(field_of(labels, options, 1).h == field_of(labels, options, threads).h);
}

void a_progress_callback_can_cancel(void**)
{
    const Labels labels = ragged_cells(grid_of(60, 50, 40), 12, 2.0, 3);
    int reports = 0;
    double last = 0;
    bool forward = true;
    Run run;
    run.progress = [&](double fraction, const char*) {
        forward = forward && fraction >= last && fraction <= 1;
        last = fraction;
        ++reports;
        return false;
    };
    compute_sizing(labels.labelling(), {}, run);
    assert_true(forward);
    const int all = reports;
    assert_true(all > 20);
    for (const int stop : {1, all / 4, all / 2, all}) {
        reports = 0;
        run.progress = [&](double, const char*) { return ++reports == stop; };
        cleft_status status = CLEFT_OK;
        try {
            compute_sizing(labels.labelling(), {}, run);
        } catch (const Error& error) {
            status = error.status();
        }
        assert_int_equal(status, CLEFT_ERROR_CANCELLED);
    }
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(is_lipschitz_and_within_limits),
        cmocka_unit_test(of_one_label_is_the_greatest_size),
        cmocka_unit_test(follows_the_feature_size),
        cmocka_unit_test(size_min_holds_for_features),
        cmocka_unit_test(explicit_sizes_go_below_a_voxel_unless_size_min_is_given),
        cmocka_unit_test(sizes_of_materials_hold_inside_and_fade_outside),
        cmocka_unit_test(interface_size_holds_at_the_interface),
        cmocka_unit_test(a_users_field_is_combined_by_minimum),
        cmocka_unit_test(a_constant_size_ignores_features),
        cmocka_unit_test(refuses_bad_options),
        cmocka_unit_test(at_interpolates_and_clamps),
        cmocka_unit_test(charge_scales_as_the_inverse_cube),
        cmocka_unit_test(scaling_keeps_the_gradation),
        cmocka_unit_test(no_field_is_scaled_by_what_is_no_factor),
        cmocka_unit_test(too_many_tets_raise_the_least_size),
        cmocka_unit_test(values_are_taken_as_they_are),
        cmocka_unit_test(does_not_depend_on_threads),
        cmocka_unit_test(a_progress_callback_can_cancel),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
