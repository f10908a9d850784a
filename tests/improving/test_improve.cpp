// Improving: better angles, and nothing else changes.
#include "cleaving/cleave.hpp"
#include "improving/improve.hpp"
#include "mesh/finish.hpp"
#include "mesh/quality.hpp"
#include "mesh/validate.hpp"
#include "support/bcc.hpp"
#include "support/cmocka.hpp"
#include "support/volumes.hpp"
#include "topology.hpp"

#include <cmath>

using namespace cleft;
using namespace cleft_test;

namespace
{

struct Case {
    Volume volume;
    LabelledMesh mesh;
};

// The volume cleaved on a jittered lattice of cells of about `cell` voxels.
Case cleaved(const LabelVolume& labels, double cell, const Vec3& spacing = Vec3(1, 1, 1))
{
    Grid grid;
    grid.dims = labels.dims;
    grid.spacing = spacing;
    Volume volume = Volume::from_labels(VoxelType::uint8, labels.voxels.data(), grid, 5, Run{});
    std::array<int32_t, 3> cells{};
    for (size_t a = 0; a < 3; ++a)
        cells[a] = std::max(1, static_cast<int32_t>(std::lround(labels.dims[a] / cell)));
    LabelledMesh mesh = cleave(volume, jittered_bcc(grid.extent(), cells, 0.05), {}, Run{});
    return {std::move(volume), std::move(mesh)};
}

Quality quality_of(const LabelledMesh& mesh) { return measure_quality(mesh.points, mesh.tets, Run{}); }

// Improves the mesh of the case and tells whether all that must stay has stayed: validity, the box, the topology of
// every material, and the volumes of the materials to `tolerance`.
bool improve_keeps_all(Case& c, const ImproveOptions& options, double tolerance)
{
    const Material materials = c.volume.material_count();
    const Topology topology = topology_of(c.mesh, materials);
    const std::vector<double> volumes = material_volumes(c.mesh, materials);
    improve(c.mesh, c.volume, options, Run{});
    bool kept = validate(c.mesh, true, Run{}).valid() && topology_of(c.mesh, materials) == topology;
    const std::vector<double> after = material_volumes(c.mesh, materials);
    for (size_t m = 0; m < volumes.size(); ++m)
        kept = kept && std::abs(after[m] - volumes[m]) <= tolerance * volumes[m];
    return kept;
}

}  // namespace

static void grains_reach_their_target(void**)
{
    Case c = cleaved(voronoi_grains({28, 24, 20}, 12), 2);
    assert_true(quality_of(c.mesh).below_20 > 0);
    assert_true(improve_keeps_all(c, {}, 0.01));
    assert_true(quality_of(c.mesh).min_dihedral > 15);
    assert_int_equal(quality_of(c.mesh).below_15, 0);
}

static void spheres_and_anisotropic_grains_stay(void**)
{
    Case spheres = cleaved(kissing_spheres(20).labels(), 2);
    assert_true(improve_keeps_all(spheres, {}, 0.01));
    assert_true(quality_of(spheres.mesh).min_dihedral > 15);
    Case grains = cleaved(voronoi_grains({20, 20, 10}, 6, 3), 1.5, Vec3(0.5, 0.5, 3));
    const double before = quality_of(grains.mesh).min_dihedral;
    assert_true(improve_keeps_all(grains, {}, 0.02));
    assert_true(quality_of(grains.mesh).min_dihedral > before);
}

static void noise_survives(void**)
{
    for (const Effort effort : {Effort::fast, Effort::best}) {
        Case c = cleaved(noise({9, 9, 9}, 5), 1.5);
        const Quality before = quality_of(c.mesh);
        ImproveOptions options;
        options.effort = effort;
        assert_true(improve_keeps_all(c, options, 0.05));
        assert_true(before.below_10 > 20);
        assert_true(quality_of(c.mesh).below_10 * 4 < before.below_10);
        assert_true(quality_of(c.mesh).min_dihedral >= before.min_dihedral);
    }
}

static void thin_and_tiny_structures_stay(void**)
{
    const LabelVolume volumes[] = {sheets({12, 12, 12}),    rods({12, 12, 12}),    single_voxel({9, 9, 9}),
                                   checkerboard({8, 8, 8}), noise({16, 16, 1}, 3), single_label({6, 6, 6})};
    for (const LabelVolume& labels : volumes) {
        Case c = cleaved(labels, 1);
        assert_true(improve_keeps_all(c, {}, 0.1));
    }
}

static void hopeless_targets_are_survived(void**)
{
    Case c = cleaved(voronoi_grains({12, 12, 12}, 8), 2);
    ImproveOptions options;
    options.target_angle = 60;
    options.effort = Effort::best;
    assert_true(improve_keeps_all(c, options, 0.2));
}

static void off_changes_nothing(void**)
{
    Case c = cleaved(voronoi_grains({12, 12, 12}, 5), 2);
    const LabelledMesh before = c.mesh;
    ImproveOptions options;
    options.effort = Effort::off;
    improve(c.mesh, c.volume, options, Run{});
    assert_true(c.mesh.tets == before.tets);
    assert_true(c.mesh.points == before.points);
    assert_true(c.mesh.material == before.material);
}

static void the_same_bytes_every_time(void**)
{
    Case c = cleaved(noise({7, 7, 7}, 4), 1.5);
    LabelledMesh other = c.mesh;
    Run two_threads;
    two_threads.threads = 2;
    improve(c.mesh, c.volume, {}, Run{});
    improve(other, c.volume, {}, two_threads);
    assert_true(c.mesh.tets == other.tets);
    assert_true(c.mesh.points == other.points);
    assert_true(c.mesh.material == other.material);
}

static void notes_tell_before_and_after(void**)
{
    Case c = cleaved(noise({7, 7, 7}, 4), 1.5);
    const Quality before = quality_of(c.mesh);
    Metrics metrics;
    Run run;
    run.metrics = &metrics;
    improve(c.mesh, c.volume, {}, run);
    const Quality after = quality_of(c.mesh);
    assert_true(std::abs(metrics.get("improving.min_angle_before") - before.min_dihedral) < 1e-9);
    assert_true(std::abs(metrics.get("improving.max_angle_after") - after.max_dihedral) < 1e-9);
    assert_true(metrics.get("improving.below_10_before") == static_cast<double>(before.below_10));
    assert_true(metrics.get("improving.below_20_after") == static_cast<double>(after.below_20));
    assert_true(metrics.get("improving.points_moved") > 0);
}

static void a_cancel_is_seen(void**)
{
    Case c = cleaved(noise({7, 7, 7}, 4), 1.5);
    Run run;
    int reports = 0;
    run.progress = [&](double, const char*) { return ++reports > 3; };
    cleft_status status = CLEFT_OK;
    try {
        improve(c.mesh, c.volume, {}, run);
    } catch (const Error& error) {
        status = error.status();
    }
    assert_int_equal(status, CLEFT_ERROR_CANCELLED);
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(grains_reach_their_target),
        cmocka_unit_test(spheres_and_anisotropic_grains_stay),
        cmocka_unit_test(noise_survives),
        cmocka_unit_test(thin_and_tiny_structures_stay),
        cmocka_unit_test(hopeless_targets_are_survived),
        cmocka_unit_test(off_changes_nothing),
        cmocka_unit_test(the_same_bytes_every_time),
        cmocka_unit_test(notes_tell_before_and_after),
        cmocka_unit_test(a_cancel_is_seen),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
