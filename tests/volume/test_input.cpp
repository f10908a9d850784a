// Label maps of all types and values, and what is refused.
#include "volume/shapes.hpp"

#include <limits>

#include "support/cmocka.hpp"

using namespace cleft;
using namespace cleft::test;

template <class Value>
static std::vector<int32_t> labels_read(VoxelType type, const std::vector<int64_t>& values)
{
    const std::vector<Value> voxels(values.begin(), values.end());
    Grid grid;
    grid.dims = {static_cast<int32_t>(voxels.size()), 1, 1};
    const Volume volume = Volume::from_labels(type, voxels.data(), grid, 5, Run());
    std::vector<int32_t> read;
    for (int64_t v = 0; v < grid.size(); ++v)
        read.push_back(number_of(volume.labels()[volume.voxel_material(v)]));
    return read;
}

template <class Value>
static bool reads_back(VoxelType type, const std::vector<int64_t>& values)
{
    return labels_read<Value>(type, values) == std::vector<int32_t>(values.begin(), values.end());
}

static void all_types_read_back(void**)
{
    assert_true(reads_back<uint8_t>(VoxelType::uint8, {255, 0, 7, 7, 128}));
    assert_true(reads_back<uint16_t>(VoxelType::uint16, {65535, 0, 7, 300, 32768}));
    assert_true(reads_back<int16_t>(VoxelType::int16, {-32768, 32767, -1, 0, 5}));
    assert_true(reads_back<uint32_t>(VoxelType::uint32, {2147483647, 0, 70000, 70000}));
    assert_true(reads_back<int32_t>(VoxelType::int32, {-2147483647 - 1, 2147483647, -5, 0}));
}

static void materials_are_numbered_as_the_voxels_have_them(void**)
{
    const std::vector<int32_t> voxels{40, -3, 1000000, 40, 7, -3};
    Grid grid;
    grid.dims = {3, 2, 1};
    const Volume volume = Volume::from_labels(VoxelType::int32, voxels.data(), grid, 5, Run());
    assert_true(volume.labels() == user_labels({40, -3, 1000000, 7}));
    assert_true(volume.voxel_counts() == std::vector<int64_t>({2, 2, 1, 1}));
    assert_true(volume.listed() == std::vector<Material>({1, 3, 0, 2}));  // ascending by label
    assert_int_equal(volume.voxel_material(2), 2);
    assert_true(volume.is_label_map());
}

static LabelImage numbered_image(int32_t labels)
{
    return label_image({labels, 1, 1}, [](int32_t i, int32_t, int32_t) { return 3 * i - 1000; });
}

static void many_labels_are_kept_up_to_the_limit(void**)
{
    for (const int32_t count : {256, 257, 65535}) {
        const Volume volume = volume_of(numbered_image(count));
        assert_int_equal(volume.material_count(), count);
        assert_int_equal(lost_centres(volume), 0);
    }
}

static void too_many_labels_are_refused(void**)
{
    const Refusal in_32_bits = refusal([] { volume_of(numbered_image(65536)); });
    assert_int_equal(in_32_bits.status, CLEFT_ERROR_ARGUMENT);
    assert_true(in_32_bits.names("65535"));
    std::vector<uint16_t> all(65536);
    for (size_t i = 0; i < all.size(); ++i)
        all[i] = static_cast<uint16_t>(i);
    Grid grid;
    grid.dims = {256, 256, 1};
    const Refusal in_16_bits = refusal([&] { Volume::from_labels(VoxelType::uint16, all.data(), grid, 5, Run()); });
    assert_int_equal(in_16_bits.status, CLEFT_ERROR_ARGUMENT);
}

static void labels_past_31_bits_are_refused(void**)
{
    const std::vector<uint32_t> voxels{0, 2147483648u};
    Grid grid;
    grid.dims = {2, 1, 1};
    const Refusal r = refusal([&] { Volume::from_labels(VoxelType::uint32, voxels.data(), grid, 5, Run()); });
    assert_int_equal(r.status, CLEFT_ERROR_ARGUMENT);
    assert_true(r.names("2147483648"));
}

static Refusal refusal_of(const std::array<int32_t, 3>& dims, const Vec3& spacing, int kernel = 5)
{
    const std::vector<uint8_t> voxels(8, 1);
    Grid grid;
    grid.dims = dims;
    grid.spacing = spacing;
    return refusal([&] { Volume::from_labels(VoxelType::uint8, voxels.data(), grid, kernel, Run()); });
}

static void bad_grids_and_kernels_are_refused(void**)
{
    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    assert_int_equal(refusal_of({2, 2, 2}, Vec3(1, 1, 1)).status, CLEFT_OK);
    const Refusal no_rows = refusal_of({2, 0, 2}, Vec3(1, 1, 1));
    assert_int_equal(no_rows.status, CLEFT_ERROR_ARGUMENT);
    assert_true(no_rows.names("2nd"));
    assert_int_equal(refusal_of({-1, 2, 2}, Vec3(1, 1, 1)).status, CLEFT_ERROR_ARGUMENT);
    for (const double bad : {0.0, -1.0, inf, nan}) {
        const Refusal r = refusal_of({2, 2, 2}, Vec3(1, 1, bad));
        assert_int_equal(r.status, CLEFT_ERROR_ARGUMENT);
        assert_true(r.names("3rd axis"));
    }
    assert_int_equal(refusal_of({2, 2, 2}, Vec3(1, 1, 1), 1).status, CLEFT_ERROR_ARGUMENT);
    assert_int_equal(refusal_of({2, 2, 2}, Vec3(1, 1, 1), 7).status, CLEFT_ERROR_ARGUMENT);
    Grid grid;
    grid.dims = {1, 1, 1};
    const Refusal null = refusal([&] { Volume::from_labels(VoxelType::uint8, nullptr, grid, 5, Run()); });
    assert_int_equal(null.status, CLEFT_ERROR_NULL);
}

static void a_grid_beyond_memory_is_bad_alloc(void**)
{
    Grid grid;
    grid.dims = {2147483647, 2147483647, 2147483647};
    const uint8_t voxel = 0;
    bool refused = false;
    try {
        Volume::from_labels(VoxelType::uint8, &voxel, grid, 5, Run());
    } catch (const std::bad_alloc&) {
        refused = true;
    }
    assert_true(refused);
}

static void a_cancel_is_seen(void**)
{
    const std::atomic<bool> cancel{true};
    Run run;
    run.cancel = &cancel;
    const auto image = checkerboard_image({8, 8, 8});
    const Refusal r = refusal([&] { Volume::from_labels(VoxelType::int32, image.voxels.data(), image.grid, 5, run); });
    assert_int_equal(r.status, CLEFT_ERROR_CANCELLED);
}

static void progress_rises_to_one(void**)
{
    std::vector<double> fractions;
    Run run;
    run.progress = [&](double fraction, const char*) {
        fractions.push_back(fraction);
        return false;
    };
    const auto image = noise_image({20, 20, 20}, 4);
    Volume::from_labels(VoxelType::int32, image.voxels.data(), image.grid, 5, run);
    assert_true(fractions.size() > 5);
    assert_true(std::is_sorted(fractions.begin(), fractions.end()));
    assert_true(fractions.back() == 1.0);
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(all_types_read_back),
        cmocka_unit_test(materials_are_numbered_as_the_voxels_have_them),
        cmocka_unit_test(many_labels_are_kept_up_to_the_limit),
        cmocka_unit_test(too_many_labels_are_refused),
        cmocka_unit_test(labels_past_31_bits_are_refused),
        cmocka_unit_test(bad_grids_and_kernels_are_refused),
        cmocka_unit_test(a_grid_beyond_memory_is_bad_alloc),
        cmocka_unit_test(a_cancel_is_seen),
        cmocka_unit_test(progress_rises_to_one),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
