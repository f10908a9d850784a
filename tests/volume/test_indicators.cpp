// Indicator functions: interpolation, interfaces, the signed case and what is refused.
#include "volume/shapes.hpp"

#include <limits>

#include "support/cmocka.hpp"

using namespace cleft;
using namespace cleft::test;

struct Fields {
    Grid grid;
    std::vector<std::vector<double>> values;

    // Adds f at the centres of all voxels.
    template <class F>
    void add(const F& f)
    {
        values.emplace_back();
        for (int32_t k = 0; k < grid.dims[2]; ++k)
            for (int32_t j = 0; j < grid.dims[1]; ++j)
                for (int32_t i = 0; i < grid.dims[0]; ++i)
                    values.back().push_back(f(grid.centre(i, j, k)));
    }
    Volume volume(const Array<int32_t>& labels = {}, int threads = 1) const
    {
        Array<const double*> pointers;
        for (const auto& field : values)
            pointers.push_back(field.data());
        Run run;
        run.threads = threads;
        return Volume::from_indicators(pointers, grid, user_labels(labels), run);
    }
};

static Fields fields_on(const std::array<int32_t, 3>& dims, const Vec3& spacing = Vec3::Ones())
{
    Fields fields;
    fields.grid.dims = dims;
    fields.grid.spacing = spacing;
    return fields;
}

static double ball(const Vec3& x, const Vec3& centre, double radius) { return radius - (x - centre).norm(); }

// Two spheres that touch, and what is around them.
static const Vec3 kFirst(10, 12, 12), kSecond(21, 12, 12);
static Fields two_spheres(const Vec3& spacing = Vec3::Ones())
{
    Fields fields = fields_on({static_cast<int32_t>(32 / spacing[0]), static_cast<int32_t>(24 / spacing[1]),
                               static_cast<int32_t>(24 / spacing[2])},
                              spacing);
    fields.add([](const Vec3& x) { return -std::max(ball(x, kFirst, 6), ball(x, kSecond, 5)); });
    fields.add([](const Vec3& x) { return ball(x, kFirst, 6); });
    fields.add([](const Vec3& x) { return ball(x, kSecond, 5); });
    return fields;
}

// Greatest distance between the sphere and the place where the material changes along its radii.
static double interface_error(const Volume& volume, const Vec3& centre, double radius)
{
    Random random;
    double worst = 0;
    for (int p = 0; p < 1000; ++p) {
        const Vec3 direction = random.in_ball(1).normalized();
        double low = radius - 1, high = radius + 1;
        const Vec3 end = centre + high * direction;
        if ((end.array() < 0).any() || (end.array() > volume.grid().extent().array()).any())
            continue;
        const Material inside = volume.material_at(centre + low * direction);
        for (int i = 0; i < 40; ++i) {
            const double r = 0.5 * (low + high);
            (volume.material_at(centre + r * direction) == inside ? low : high) = r;
        }
        worst = std::max(worst, std::abs(low - radius));
    }
    return worst;
}

static void exact_distances_give_exact_spheres(void**)
{
    const Volume volume = two_spheres().volume();
    assert_int_equal(volume.material_count(), 3);
    assert_true(interface_error(volume, kFirst, 6) < 0.004);
    assert_true(interface_error(volume, kSecond, 5) < 0.004);
    assert_true(interface_error(two_spheres(Vec3(0.5, 1, 2)).volume(), kFirst, 6) < 0.02);
}

// What is outside of all has a crease where the spheres touch. It is kept, wherever that function stands among the
// others, if it is nothing but what they leave.
static void the_gap_between_spheres_that_touch_stays_open(void**)
{
    const Fields given = two_spheres();
    const Vec3 touch(16, 12, 12), in_gap = touch + Vec3(0, 0.3, 0.9);
    for (size_t place = 0; place < 3; ++place) {
        Fields fields = given;
        std::rotate(fields.values.begin(), fields.values.begin() + 1,
                    fields.values.begin() + 1 + static_cast<std::ptrdiff_t>(place));
        const Volume volume = fields.volume();
        assert_int_equal(volume.material_at(in_gap), place);
        Samples s;
        volume.sample_gradient(in_gap, s);
        assert_int_equal(s.best(), place);
        assert_true(s.value[place] > 0 &&
                    s.value[place] == -std::max(s.value[(place + 1) % 3], s.value[(place + 2) % 3]));
        assert_int_equal(lost_centres(volume), 0);
    }
    Fields other = given;
    other.values[0][77] += 1;
    assert_int_not_equal(other.volume().material_at(in_gap), 0);
}

// Past the outermost centres the function goes on as a line: half a voxel of it, times the curvature of the sphere.
static void a_sphere_cut_by_the_walls_stays_where_it_is(void**)
{
    Fields fields = fields_on({16, 16, 16});
    fields.add([](const Vec3& x) { return ball(x, Vec3(3, 4, 5), 9); });
    Random random;
    const Volume volume = fields.volume();
    double worst = 0;
    Samples s;
    for (int p = 0; p < 2000; ++p) {
        Vec3 x = random.in_box(volume.grid());
        x[p % 3] = 0;
        volume.sample(x, s);
        if (std::abs((x - Vec3(3, 4, 5)).norm() - 9) < 1)
            worst = std::max(worst, std::abs(s.value[1] - ball(x, Vec3(3, 4, 5), 9)));
    }
    assert_true(worst > 0 && worst < 0.1);
}

static void one_function_is_signed(void**)
{
    Fields fields = fields_on({20, 20, 20});
    fields.add([](const Vec3& x) { return ball(x, Vec3(10, 10, 10), 6); });
    const Volume volume = fields.volume();
    assert_false(volume.is_label_map());
    assert_true(volume.labels() == user_labels({0, 1}));
    assert_int_equal(volume.material_at(Vec3(10, 10, 10)), 1);
    assert_int_equal(volume.material_at(Vec3(1, 1, 1)), 0);
    assert_true(interface_error(volume, Vec3(10, 10, 10), 6) < 0.004);
    Samples s;
    volume.sample_gradient(Vec3(12, 11, 10), s);
    assert_true(s.value[0] == -s.value[1] && s.gradient[0] == -s.gradient[1]);
    assert_true((s.gradient[1] - Vec3(-2, -1, 0).normalized()).norm() < 0.02);
    int64_t inside = 0;
    for (const double f : fields.values[0])
        inside += f > 0;
    assert_int_equal(volume.voxel_counts()[1], inside);
    assert_int_equal(volume.voxel_counts()[0], 8000 - inside);
}

static void linear_functions_are_exact_up_to_the_walls(void**)
{
    for (const std::array<int32_t, 3>& dims : {std::array<int32_t, 3>{7, 6, 5}, {2, 3, 4}, {4, 2, 3}, {3, 4, 2}}) {
        Fields fields = fields_on(dims, Vec3(0.5, 1, 4));
        const auto f = [](const Vec3& x) { return 3 + x[0] - 2 * x[1] + 0.5 * x[2]; };
        const auto g = [](const Vec3& x) { return 1 - x[0] + 0.25 * x[2]; };
        fields.add(f);
        fields.add(g);
        const Volume volume = fields.volume();
        Random random;
        Samples s;
        for (int p = 0; p < 200; ++p) {
            const Vec3 x = random.in_box(volume.grid());
            volume.sample_gradient(x, s);
            assert_true(std::abs(s.value[0] - f(x)) < 1e-5 && std::abs(s.value[1] - g(x)) < 1e-5);
            assert_true((s.gradient[0] - Vec3(1, -2, 0.5)).norm() < 1e-4);
        }
    }
}

static void values_at_centres_are_those_given(void**)
{
    Random random;
    Fields fields = fields_on({6, 5, 1}, Vec3(0.1, 0.3, 0.7));
    for (int f = 0; f < 4; ++f)
        fields.add([&](const Vec3&) { return random.unit(); });
    const Volume volume = fields.volume({5, 9, -2, 1000});
    assert_true(volume.labels() == user_labels({5, 9, -2, 1000}));
    assert_int_equal(lost_centres(volume), 0);
    Samples s;
    volume.sample(volume.grid().centre(3, 2, 0), s);
    assert_int_equal(s.size(), 4);
    for (size_t f = 0; f < 4; ++f)
        assert_true(std::abs(s.value[f] - fields.values[f][3 + 6 * 2]) < 1e-6);
}

static void gradients_are_those_of_the_functions(void**)
{
    Random random;
    Fields fields = fields_on({8, 7, 6}, Vec3(0.5, 0.5, 3));
    for (int f = 0; f < 4; ++f)
        fields.add([&](const Vec3&) { return random.unit(); });
    assert_true(gradient_error(fields.volume(), 500) < 1e-2);
    assert_true(gradient_error(two_spheres().volume(), 500) < 1e-2);
}

static void float_and_double_fields_are_the_same(void**)
{
    const Fields fields = two_spheres();
    std::vector<std::vector<float>> copies;
    Array<const float*> pointers;
    for (const auto& field : fields.values) {
        copies.emplace_back();
        for (const double f : field)
            copies.back().push_back(static_cast<float>(f));
    }
    for (const auto& copy : copies)
        pointers.push_back(copy.data());
    const Volume a = fields.volume({}, 2), b = Volume::from_indicators(pointers, fields.grid, {}, Run());
    Random random;
    Samples s, t;
    for (int p = 0; p < 300; ++p) {
        const Vec3 x = random.in_box(fields.grid);
        a.sample(x, s);
        b.sample(x, t);
        assert_true(s.value == t.value);
        assert_int_equal(a.single_material_near(x, 1), b.single_material_near(x, 1));
    }
}

static void single_material_near_is_right_and_finds_most(void**)
{
    const Volume spheres = two_spheres().volume();
    assert_true(single_share(spheres, 0, 3000) > 0.6);
    assert_true(single_share(spheres, 1, 3000) > 0.1);
    assert_true(single_share(spheres, 1000, 50) == 0.0);
    assert_true(single_share(two_spheres(Vec3(0.5, 1, 2)).volume(), 1, 3000) > 0.1);
    Random random;
    Fields noise = fields_on({13, 12, 11});
    for (int f = 0; f < 3; ++f)
        noise.add([&](const Vec3&) { return random.unit(); });
    assert_true(single_share(noise.volume(), 0.5, 3000) >= 0);
    // Overshoots of the interpolation: far apart in most places, close in some.
    Fields rough = fields_on({40, 40, 40});
    rough.add([&](const Vec3&) { return random.below(400) == 0 ? 0.1 : 1.0 + 0.1 * random.unit(); });
    assert_true(single_share(rough.volume(), 0.5, 3000) >= 0);
}

static void one_sided_functions_hold_one_material(void**)
{
    Fields fields = fields_on({9, 9, 9});
    fields.add([](const Vec3&) { return 1.0; });
    assert_true(fields.volume().single_material_near(Vec3(4, 4, 4), 1e6));
}

static Refusal refusal_of(Fields fields, const Array<int32_t>& labels = {})
{
    return refusal([&] { fields.volume(labels); });
}

static void bad_values_are_refused_by_place(void**)
{
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Fields fields = two_spheres();
        fields.values[2][1234] = bad;
        fields.values[2][15000] = bad;
        const Refusal r = refusal_of(fields);
        assert_int_equal(r.status, CLEFT_ERROR_NOT_FINITE);
        assert_true(r.names("3rd indicator function") && r.names("19th along x, the 15th along y and the 2nd along z"));
    }
}

static void bad_arguments_are_refused(void**)
{
    const Fields fields = two_spheres();
    assert_int_equal(refusal_of(fields, {1, 2}).status, CLEFT_ERROR_ARGUMENT);
    assert_int_equal(refusal_of(fields, {1, 2, 1}).status, CLEFT_ERROR_ARGUMENT);
    assert_int_equal(refusal_of(fields_on({3, 3, 3})).status, CLEFT_ERROR_ARGUMENT);
    Fields flat = fields;
    flat.grid.dims[0] = 0;
    assert_int_equal(refusal_of(flat).status, CLEFT_ERROR_ARGUMENT);
    const Array<const float*> null{nullptr};
    assert_int_equal(refusal([&] { Volume::from_indicators(null, fields.grid, {}, Run()); }).status, CLEFT_ERROR_NULL);
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(exact_distances_give_exact_spheres),
        cmocka_unit_test(the_gap_between_spheres_that_touch_stays_open),
        cmocka_unit_test(a_sphere_cut_by_the_walls_stays_where_it_is),
        cmocka_unit_test(one_function_is_signed),
        cmocka_unit_test(linear_functions_are_exact_up_to_the_walls),
        cmocka_unit_test(values_at_centres_are_those_given),
        cmocka_unit_test(gradients_are_those_of_the_functions),
        cmocka_unit_test(float_and_double_fields_are_the_same),
        cmocka_unit_test(single_material_near_is_right_and_finds_most),
        cmocka_unit_test(one_sided_functions_hold_one_material),
        cmocka_unit_test(bad_values_are_refused_by_place),
        cmocka_unit_test(bad_arguments_are_refused),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
