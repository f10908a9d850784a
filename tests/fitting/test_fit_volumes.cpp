// Fitting of volumes: coarse meshes of balls keep their volume, and nothing else is lost for it.
#include "support/cmocka.hpp"

#include "background/lattice.hpp"
#include "checking/validate.hpp"
#include "cleaving/cleave.hpp"
#include "fitting/fit_volumes.hpp"
#include "fitting/material_offsets.hpp"
#include "mesh/materials.hpp"
#include "mesh/quality.hpp"
#include "support/volumes.hpp"

#include <cmath>

using namespace cleft;

namespace
{

constexpr int kSide = 32;

// The signed distance of a ball, positive inside. Its centre may lie in a wall of the box.
Volume ball(const Vec3& centre, double radius)
{
    const Grid grid{{kSide, kSide, kSide}, Vec3(1, 1, 1)};
    Array<double> field;
    for (int32_t k = 0; k < kSide; ++k)
        for (int32_t j = 0; j < kSide; ++j)
            for (int32_t i = 0; i < kSide; ++i)
                field.push_back(radius - (grid.centre(i, j, k) - centre).norm());
    return Volume::from_indicators(Array<const double*>{field.data()}, grid, {}, Run());
}

struct Loss {
    double before, after;
};

// Relative error of the ball's volume before and after fitting; asserts that the mesh stays sound.
Loss fitted(const Volume& volume, double exact, double size)
{
    LabelledMesh mesh = cleave(volume, lattice_background(volume.grid(), size, Run()), CleaveOptions(), Run());
    const Quality quality_before = measure_quality(mesh.points, mesh.tets, Run());
    Loss loss{material_volumes(mesh, 2)[1] / exact - 1, 0};
    fit_volumes(mesh, volume, 20, Run());
    loss.after = material_volumes(mesh, 2)[1] / exact - 1;
    const Validation found = validate(mesh, true, Run());
    assert_string_equal(found.first_fault.c_str(), "");
    assert_true(std::abs(found.volume - found.box_volume) < 1e-9 * found.box_volume);
    const Quality quality = measure_quality(mesh.points, mesh.tets, Run());
    assert_true(quality.min_dihedral > std::min(11.0, quality_before.min_dihedral - 1e-9));
    return loss;
}

void a_coarse_ball_keeps_its_volume(void**)
{
    const double radius = 11.3, exact = 4 * M_PI / 3 * std::pow(radius, 3);
    const Volume volume = ball(Vec3(16.2, 15.7, 16.1), radius);
    for (const double size : {2.0, 4.0, 6.0}) {
        const Loss loss = fitted(volume, exact, size);
        assert_true(loss.before < 0);  // chords always lose
        // Points stay a little short of where volumes want them.
        assert_true(std::abs(loss.after) < 0.1 * std::abs(loss.before) + 0.002);
    }
}

void half_a_ball_at_a_wall_keeps_its_volume(void**)
{
    const double radius = 12.4, exact = 2 * M_PI / 3 * std::pow(radius, 3);
    const Volume volume = ball(Vec3(16.2, 0, 16.1), radius);
    const Loss loss = fitted(volume, exact, 4);
    assert_true(loss.before < 0);
    assert_true(std::abs(loss.after) < 0.3 * std::abs(loss.before));
}

// Three materials meet along the equator, which is a chord too.
void halves_of_a_ball_keep_their_volumes(void**)
{
    const double radius = 11.3, exact = 2 * M_PI / 3 * std::pow(radius, 3);
    const Vec3 centre(16.2, 15.7, 16.1);
    const Grid grid{{kSide, kSide, kSide}, Vec3(1, 1, 1)};
    Array<double> outside, upper, lower;
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
        const Vec3 x = grid.centre(i % kSide, i / kSide % kSide, i / kSide / kSide) - centre;
        const double depth = radius - x.norm(), height = x.dot(Vec3(0.2, -0.1, 1).normalized());
        outside.push_back(-depth);
        upper.push_back(std::min(depth, height));
        lower.push_back(std::min(depth, -height));
    }
    const Volume volume =
        Volume::from_indicators(Array<const double*>{outside.data(), upper.data(), lower.data()}, grid, {}, Run());
    LabelledMesh mesh = cleave(volume, lattice_background(grid, 4, Run()), CleaveOptions(), Run());
    const Array<double> before = material_volumes(mesh, 3);
    fit_volumes(mesh, volume, 20, Run());
    const Array<double> after = material_volumes(mesh, 3);
    for (const size_t half : {size_t{1}, size_t{2}}) {
        assert_true(before[half] < 0.98 * exact);
        assert_true(std::abs(after[half] - exact) < 0.4 * std::abs(before[half] - exact));
    }
    assert_string_equal(validate(mesh, true, Run()).first_fault.c_str(), "");
}

// Three materials in a row, and one that touches nothing.
void offsets_give_what_is_missing(void**)
{
    const Array<SharedArea> shared{{0, 1, 2.0}, {1, 2, 0.5}, {0, 1, 1.0}};
    const Array<double> missing{3, -2, -1, 0};
    const Array<double> offsets = material_offsets(shared, missing);
    Array<double> gained(4, 0);
    for (const SharedArea& c : shared) {
        const auto a = static_cast<size_t>(c.first), b = static_cast<size_t>(c.second);
        gained[a] += c.area * (offsets[a] - offsets[b]);
        gained[b] -= c.area * (offsets[a] - offsets[b]);
    }
    for (size_t m = 0; m < 4; ++m)
        assert_true(std::abs(gained[m] - missing[m]) < 1e-5);
    for (const double offset : material_offsets(shared, {0, 0, 0, 0}))
        assert_true(offset == 0);
}

// A label that is not in the mesh misses what nothing can give; so do two that miss something together, be it rounding.
void offsets_leave_out_what_nothing_can_give(void**)
{
    const Array<SharedArea> shared{{0, 1, 2000.0}, {1, 2, 500.0}, {3, 4, 80.0}};
    const Array<double> sound{3, -2, -1, 0.5, -0.5, 0};
    const Array<double> expected = material_offsets(shared, sound);
    const auto agrees = [&](const Array<double>& missing, double tolerance) {
        const Array<double> offsets = material_offsets(shared, missing);
        for (const SharedArea& c : shared) {
            const auto a = static_cast<size_t>(c.first), b = static_cast<size_t>(c.second);
            if (!(std::abs((offsets[a] - offsets[b]) - (expected[a] - expected[b])) < tolerance))
                return false;
        }
        return true;
    };
    assert_true(agrees({3, -2, -1, 0.5, -0.5, 27}, 1e-8));
    assert_true(agrees({3 + 1e-5, -2, -1, 0.5, -0.5 + 1e-5, 0}, 1e-6));
    assert_true(agrees({3 - 4, -2 - 5, -1 - 1, 0.5 + 1, -0.5 + 1, 0}, 1e-8));  // shared by areas: 2000, 2500, 500
    const Array<double> rounding = material_offsets({{0, 1, 4096.0}}, {-0.0298532, 0.0298533});
    assert_true(std::abs(rounding[1] - rounding[0] - 0.0298532 / 4096) < 1e-9);
}

void grains_have_the_volume_of_their_voxels(void**)
{
    const auto grains = cleft_test::voronoi_grains({28, 26, 24}, 40, 3);
    const Grid grid{{28, 26, 24}, Vec3(1, 1.2, 0.9)};
    const Volume volume = Volume::from_labels(VoxelType::uint8, grains.voxels.data(), grid, 5, Run());
    LabelledMesh mesh = cleave(volume, lattice_background(grid, 2.2, Run()), CleaveOptions(), Run());
    const Array<int64_t> voxels = volume.voxel_counts();
    const auto worst = [&] {
        const Array<double> volumes = material_volumes(mesh, static_cast<Material>(voxels.size()));
        double most = 0;
        for (size_t m = 0; m < voxels.size(); ++m)
            if (voxels[m] > 100)
                most =
                    std::max(most, std::abs(volumes[m] / (static_cast<double>(voxels[m]) * grid.spacing.prod()) - 1));
        return most;
    };
    const double before = worst();
    fit_volumes(mesh, volume, 20, Run());
    assert_true(before > 0.02);
    assert_true(worst() < 0.01);
    assert_string_equal(validate(mesh, true, Run()).first_fault.c_str(), "");
}

// One voxel thick, along a diagonal: as thin as the smoothing of its label, it needs more rounds.
void a_thin_sheet_has_the_volume_of_its_voxels(void**)
{
    constexpr int32_t kWide = 34;
    const Grid grid{{kWide, kWide, kWide}, Vec3(1, 1, 1)};
    Array<uint8_t> voxels;
    for (int32_t v = 0; v < kWide * kWide * kWide; ++v)
        voxels.push_back(v % kWide + v / kWide % kWide == kWide - 1);
    const Volume volume = Volume::from_labels(VoxelType::uint8, voxels.data(), grid, 5, Run());
    LabelledMesh mesh = cleave(volume, lattice_background(grid, 0.9, Run()), CleaveOptions(), Run());
    fit_volumes(mesh, volume, 20, Run());
    assert_true(std::abs(material_volumes(mesh, 2)[1] / (kWide * kWide) - 1) < 0.005);
}

void a_flat_interface_stays_flat(void**)
{
    const Grid grid{{16, 16, 16}, Vec3(1, 1, 1)};
    Array<double> field;
    for (int i = 0; i < 16 * 16 * 16; ++i)
        field.push_back(grid.centre(i % 16, i / 16 % 16, i / 256).dot(Vec3(0.3, 0.2, 1).normalized()) - 9.1);
    const Volume volume = Volume::from_indicators(Array<const double*>{field.data()}, grid, {}, Run());
    LabelledMesh mesh = cleave(volume, lattice_background(grid, 2.2, Run()), CleaveOptions(), Run());
    const Array<Vec3> before = mesh.points;
    fit_volumes(mesh, volume, 20, Run());
    double furthest = 0;
    for (size_t i = 0; i < before.size(); ++i)
        furthest = std::max(furthest, (before[i] - mesh.points[i]).norm());
    assert_true(furthest < 1e-3);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(a_coarse_ball_keeps_its_volume),
        cmocka_unit_test(half_a_ball_at_a_wall_keeps_its_volume),
        cmocka_unit_test(halves_of_a_ball_keep_their_volumes),
        cmocka_unit_test(offsets_give_what_is_missing),
        cmocka_unit_test(offsets_leave_out_what_nothing_can_give),
        cmocka_unit_test(grains_have_the_volume_of_their_voxels),
        cmocka_unit_test(a_thin_sheet_has_the_volume_of_its_voxels),
        cmocka_unit_test(a_flat_interface_stays_flat),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
