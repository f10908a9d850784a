// Every voxel centre keeps its label in the smoothed field, whatever the map.
#include "volume/shapes.hpp"

#include "support/cmocka.hpp"

using namespace cleft;
using namespace cleft::test;

static int64_t lost_for_all_kernels(LabelImage image)
{
    int64_t lost = 0;
    for (int kernel = 2; kernel <= 6; ++kernel)
        for (const Vec3& spacing : {Vec3(1, 1, 1), Vec3(0.5, 0.5, 3), Vec3(1e-6, 3e-6, 1e6)}) {
            image.grid.spacing = spacing;
            lost += lost_centres(volume_of(image, kernel));
        }
    return lost;
}

static void noise_keeps_every_centre(void**)
{
    for (const int32_t labels : {2, 5, 300})
        assert_int_equal(lost_for_all_kernels(noise_image({17, 16, 15}, labels)), 0);
}

static void checkerboard_keeps_every_centre(void**)
{
    assert_int_equal(lost_for_all_kernels(checkerboard_image({11, 12, 13})), 0);
}

static void sheets_and_rods_keep_every_centre(void**)
{
    for (int32_t period = 2; period <= 5; ++period) {
        const auto sheets = label_image({14, 13, 12}, [=](int32_t i, int32_t, int32_t) { return i % period == 0; });
        const auto rods = label_image(
            {14, 13, 12}, [=](int32_t i, int32_t j, int32_t) { return i % period == 0 && j % period == 0; });
        const auto tilted = label_image(
            {14, 13, 12}, [=](int32_t i, int32_t j, int32_t k) { return (i + 2 * j + 3 * k) % (3 * period) < 3; });
        assert_int_equal(lost_for_all_kernels(sheets), 0);
        assert_int_equal(lost_for_all_kernels(rods), 0);
        assert_int_equal(lost_for_all_kernels(tilted), 0);
    }
}

static void single_voxels_keep_their_centre(void**)
{
    for (int32_t corner = 0; corner < 8; ++corner) {
        const auto image = label_image({9, 9, 9}, [=](int32_t i, int32_t j, int32_t k) {
            const bool centre = i == 4 && j == 4 && k == 4;
            const bool at_corner = i == 8 * (corner & 1) && j == 8 * (corner >> 1 & 1) && k == 8 * (corner >> 2);
            return centre ? 2 : at_corner ? 1 : 0;
        });
        assert_int_equal(lost_for_all_kernels(image), 0);
    }
}

static void volumes_of_one_voxel_along_an_axis_keep_every_centre(void**)
{
    for (const std::array<int32_t, 3>& dims :
         {std::array<int32_t, 3>{1, 1, 1}, {1, 9, 8}, {9, 1, 8}, {9, 8, 1}, {1, 1, 20}, {2, 2, 2}, {3, 1, 2}})
        assert_int_equal(lost_for_all_kernels(noise_image(dims, 3)), 0);
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(noise_keeps_every_centre),
        cmocka_unit_test(checkerboard_keeps_every_centre),
        cmocka_unit_test(sheets_and_rods_keep_every_centre),
        cmocka_unit_test(single_voxels_keep_their_centre),
        cmocka_unit_test(volumes_of_one_voxel_along_an_axis_keep_every_centre),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
