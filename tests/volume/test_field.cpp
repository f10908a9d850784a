// The smoothed field of a label map at any point.
#include "volume/shapes.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "support/cmocka.hpp"

using namespace cleft;
using namespace cleft::test;

static std::vector<LabelImage> images()
{
    std::vector<LabelImage> all{noise_image({9, 10, 11}, 5), noise_image({8, 8, 8}, 400),
                                voronoi_image({20, 18, 16}, 9), checkerboard_image({7, 7, 7}),
                                noise_image({12, 1, 12}, 3)};
    all[2].grid.spacing = Vec3(0.5, 0.5, 3);
    return all;
}

// The samples at a point are ascending, positive and add up to one, and the best one is the material there.
static bool is_partition(const Volume& volume, const Vec3& x, Samples& s)
{
    volume.sample(x, s);
    double sum = 0;
    for (const double f : s.value) {
        if (!(f > 0))
            return false;
        sum += f;
    }
    return s.material.size() == s.value.size() && std::abs(sum - 1) < 1e-12 &&
           std::is_sorted(s.material.begin(), s.material.end(), std::less_equal<Material>()) &&
           s.material[s.best()] == volume.material_at(x);
}

static void shares_are_a_partition_of_unity(void**)
{
    for (const LabelImage& image : images())
        for (int kernel = 2; kernel <= 6; ++kernel) {
            const Volume volume = volume_of(image, kernel);
            Random random;
            Samples s;
            int wrong = 0;
            for (int p = 0; p < 500; ++p)
                wrong += !is_partition(volume, random.in_box(volume.grid()), s);
            for (int32_t i = 0; i <= image.grid.dims[0]; ++i)
                wrong += !is_partition(volume, Vec3(i * image.grid.spacing[0], 0, 0), s);
            assert_int_equal(wrong, 0);
        }
}

static void gradients_are_those_of_the_field(void**)
{
    for (const LabelImage& image : images())
        for (int kernel = 2; kernel <= 6; ++kernel)
            assert_true(gradient_error(volume_of(image, kernel), 300) < 2e-2);
}

static void gradients_add_up_to_nothing(void**)
{
    const Volume volume = volume_of(voronoi_image({16, 16, 16}, 6));
    Random random;
    Samples s;
    double worst = 0;
    for (int p = 0; p < 500; ++p) {
        volume.sample_gradient(random.in_box(volume.grid()), s);
        Vec3 sum = Vec3::Zero();
        for (const Vec3& g : s.gradient)
            sum += g;
        worst = std::max(worst, sum.norm());
    }
    assert_true(worst < 1e-6);
}

static void sampling_with_and_without_gradient_agree(void**)
{
    const Volume volume = volume_of(noise_image({10, 10, 10}, 7));
    Random random;
    Samples plain, both;
    for (int p = 0; p < 300; ++p) {
        const Vec3 x = random.in_box(volume.grid());
        volume.sample(x, plain);
        volume.sample_gradient(x, both);
        assert_true(plain.material == both.material);
        assert_true(plain.value == both.value);
        assert_int_equal(both.gradient.size(), both.value.size());
    }
}

static void interfaces_meet_the_walls_at_right_angles(void**)
{
    const Volume volume = volume_of(voronoi_image({14, 14, 14}, 12));
    const Vec3 extent = volume.grid().extent();
    Random random;
    Samples s;
    double worst = 0, along = 0;
    for (int p = 0; p < 600; ++p) {
        Vec3 x = random.in_box(volume.grid());
        const int axis = p % 3;
        x[axis] = p % 2 ? extent[axis] : 0;
        volume.sample_gradient(x, s);
        for (const Vec3& g : s.gradient) {
            worst = std::max(worst, std::abs(g[axis]));
            along = std::max(along, g.norm());
        }
    }
    assert_true(along > 0.2);
    assert_true(worst < 1e-5);
}

static void points_outside_are_moved_to_the_box(void**)
{
    const Volume volume = volume_of(noise_image({5, 6, 7}, 4));
    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    Samples inside, outside;
    volume.sample(Vec3(0, 6, 3.3), inside);
    volume.sample(Vec3(-1e300, inf, 3.3), outside);
    assert_true(inside.material == outside.material && inside.value == outside.value);
    volume.sample(Vec3(0, 0, 0), inside);
    volume.sample(Vec3(nan, nan, -inf), outside);
    assert_true(inside.material == outside.material && inside.value == outside.value);
}

static void one_label_fills_the_box(void**)
{
    const Volume volume = volume_of(label_image({6, 5, 4}, [](int32_t, int32_t, int32_t) { return -7; }));
    Samples s;
    volume.sample_gradient(Vec3(1.2, 0.1, 3.9), s);
    assert_int_equal(s.size(), 1);
    assert_true(s.value[0] == 1.0 && s.gradient[0] == Vec3::Zero());
    assert_true(volume.single_material_near(Vec3(3, 3, 2), 10));
}

static std::map<int32_t, double> values_by_label(const Volume& volume, const Vec3& x)
{
    Samples samples;
    volume.sample(x, samples);
    std::map<int32_t, double> values;
    for (size_t i = 0; i < samples.size(); ++i)
        values[number_of(volume.labels()[samples.material[i]])] = samples.value[i];
    return values;
}

static void the_field_does_not_depend_on_label_values(void**)
{
    const LabelImage image = noise_image({9, 9, 9}, 6);
    // More than 256 labels need wider storage: 400 others in a far corner.
    LabelImage wide = label_image({40, 40, 9}, [&](int32_t i, int32_t j, int32_t k) {
        if (i < 20 && j < 20)
            return image.voxels[static_cast<size_t>(std::min(i, 8) + 9 * (std::min(j, 8) + 9 * k))] * 10 - 30;
        return 100 + (i + 40 * j) % 400;
    });
    LabelImage narrow = wide;
    for (int32_t& label : narrow.voxels)
        label = label >= 100 ? 100 + label % 4 : label;
    const Volume a = volume_of(wide), b = volume_of(narrow);
    assert_true(a.material_count() > 256 && b.material_count() < 256);
    Random random;
    for (int p = 0; p < 300; ++p) {
        const Vec3 x(8 * random.unit(), 8 * random.unit(), 9 * random.unit());
        assert_true(values_by_label(a, x) == values_by_label(b, x));
    }
}

static void single_material_near_is_right_and_finds_most(void**)
{
    for (const double spacing : {1.0, 1e-3}) {
        LabelImage image = voronoi_image({40, 40, 40}, 4);
        image.grid.spacing = Vec3(spacing, spacing, 2 * spacing);
        const Volume volume = volume_of(image);
        assert_true(single_share(volume, 0, 2000) > 0.55);
        assert_true(single_share(volume, spacing, 2000) > 0.4);
        assert_true(single_share(volume, 3 * spacing, 2000) > 0.15);
        assert_true(single_share(volume, 100 * spacing, 200) == 0.0);
    }
    assert_true(single_share(volume_of(noise_image({12, 12, 12}, 3)), 0.5, 500) >= 0);
}

static std::vector<double> fingerprint(const Volume& volume)
{
    Random random;
    Samples s;
    std::vector<double> all;
    for (int p = 0; p < 2000; ++p) {
        volume.sample(random.in_box(volume.grid()), s);
        all.insert(all.end(), s.material.begin(), s.material.end());
        all.insert(all.end(), s.value.begin(), s.value.end());
    }
    return all;
}

static void the_field_is_the_same_for_any_number_of_threads(void**)
{
    for (int kernel = 2; kernel <= 6; ++kernel)
        for (const LabelImage& image : {voronoi_image({24, 23, 50}, 20), noise_image({24, 24, 24}, 5)}) {
            const auto one = fingerprint(volume_of(image, kernel, 1));
            assert_true(one == fingerprint(volume_of(image, kernel, 2)));
            assert_true(one == fingerprint(volume_of(image, kernel, 5)));
        }
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(shares_are_a_partition_of_unity),
        cmocka_unit_test(gradients_are_those_of_the_field),
        cmocka_unit_test(gradients_add_up_to_nothing),
        cmocka_unit_test(sampling_with_and_without_gradient_agree),
        cmocka_unit_test(interfaces_meet_the_walls_at_right_angles),
        cmocka_unit_test(points_outside_are_moved_to_the_box),
        cmocka_unit_test(one_label_fills_the_box),
        cmocka_unit_test(the_field_does_not_depend_on_label_values),
        cmocka_unit_test(single_material_near_is_right_and_finds_most),
        cmocka_unit_test(the_field_is_the_same_for_any_number_of_threads),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
