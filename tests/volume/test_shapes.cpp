// Smoothing keeps the volumes of shapes, thin ones too, and puts interfaces where they belong.
#include "volume/shapes.hpp"

#include "support/cmocka.hpp"

using namespace cleft;
using namespace cleft::test;

static double volume_ratio(const LabelImage& image, int samples, int32_t material = 1)
{
    const Volume volume = volume_of(image);
    const auto m = static_cast<size_t>(material);
    return sampled_volumes(volume, samples)[m] / static_cast<double>(volume.voxel_counts()[m]);
}

static void spheres_keep_their_volume(void**)
{
    for (const double radius : {4.0, 7.3, 10.0})
        assert_true(std::abs(volume_ratio(sphere_image(28, radius), 3) - 1) < 0.01);
}

static void cells_keep_their_volumes(void**)
{
    const Volume volume = volume_of(voronoi_image({36, 36, 36}, 8));
    const auto sampled = sampled_volumes(volume, 2);
    const auto voxels = volume.voxel_counts();
    for (size_t m = 0; m < voxels.size(); ++m)
        assert_true(std::abs(sampled[m] / static_cast<double>(voxels[m]) - 1) < 0.015);
}

static void thin_sheets_keep_their_volume(void**)
{
    const auto flat = label_image({15, 15, 15}, [](int32_t, int32_t, int32_t k) { return k == 7; });
    assert_true(std::abs(volume_ratio(flat, 8) - 1) < 0.03);
    const auto tilted = label_image({24, 24, 24}, [](int32_t i, int32_t j, int32_t k) {
        return std::abs(Vec3(i - 11.5, j - 11.5, k - 11.5).dot(Vec3(2, 1, 4).normalized())) < 0.75;
    });
    assert_true(std::abs(volume_ratio(tilted, 4) - 1) < 0.05);
}

static void rods_and_single_voxels_keep_most_of_their_volume(void**)
{
    const auto rod = label_image({9, 9, 5}, [](int32_t i, int32_t j, int32_t) { return i == 4 && j == 4; });
    assert_true(std::abs(volume_ratio(rod, 16) - 1) < 0.15);
    const auto voxel =
        label_image({9, 9, 9}, [](int32_t i, int32_t j, int32_t k) { return i == 4 && j == 4 && k == 4; });
    assert_true(std::abs(volume_ratio(voxel, 16) - 1) < 0.15);
}

// Where the material changes between two points, by bisection.
static double crossing(const Volume& volume, Vec3 a, Vec3 b)
{
    const Material inside = volume.material_at(a);
    const Vec3 start = a;
    for (int i = 0; i < 50; ++i) {
        const Vec3 middle = 0.5 * (a + b);
        (volume.material_at(middle) == inside ? a : b) = middle;
    }
    return (a - start).norm();
}

static void a_flat_interface_lies_between_the_voxels(void**)
{
    for (int kernel = 2; kernel <= 6; ++kernel) {
        auto image = label_image({12, 12, 12}, [](int32_t i, int32_t, int32_t) { return i >= 5; });
        image.grid.spacing = Vec3(0.5, 2, 3);
        const Volume volume = volume_of(image, kernel);
        Random random;
        for (int p = 0; p < 50; ++p) {
            const Vec3 x(0, 24 * random.unit(), 36 * random.unit());
            assert_true(std::abs(crossing(volume, x, x + Vec3(6, 0, 0)) - 2.5) < 1e-5);
        }
    }
}

static void a_sphere_is_smooth(void**)
{
    const double radius = 10;
    const Volume volume = volume_of(sphere_image(28, radius));
    const Vec3 centre = Vec3::Constant(14);
    Random random;
    double sum = 0, worst = 0, worst_normal = 0;
    constexpr int rays = 2000;
    Samples s;
    for (int p = 0; p < rays; ++p) {
        const Vec3 direction = random.in_ball(1).normalized();
        const double r = crossing(volume, centre, centre + 13 * direction);
        sum += std::abs(r - radius);
        worst = std::max(worst, std::abs(r - radius));
        volume.sample_gradient(centre + r * direction, s);
        const Vec3 normal = -s.gradient[1].normalized();
        worst_normal += std::acos(std::min(1.0, normal.dot(direction))) * 180 / 3.14159265 / rays;
    }
    // Stairs would be 0.24 voxels away and 37 degrees off on average.
    assert_true(sum / rays < 0.1);
    assert_true(worst < 0.5);
    assert_true(worst_normal < 6);
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(spheres_keep_their_volume),
        cmocka_unit_test(cells_keep_their_volumes),
        cmocka_unit_test(thin_sheets_keep_their_volume),
        cmocka_unit_test(rods_and_single_voxels_keep_most_of_their_volume),
        cmocka_unit_test(a_flat_interface_lies_between_the_voxels),
        cmocka_unit_test(a_sphere_is_smooth),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
