// Improving: better angles, and nothing else changes.
#include "checking/validate.hpp"
#include "cleaving/cleave.hpp"
#include "improving/improve.hpp"
#include "mesh/materials.hpp"
#include "mesh/quality.hpp"
#include "support/bcc.hpp"
#include "support/cmocka.hpp"
#include "support/topology.hpp"
#include "support/volumes.hpp"

#include <cmath>
#include <set>

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

// All angles in 25 .. 148.5 degrees, the target of default options, or in those of a wanted one.
bool reaches_the_target(const LabelledMesh& mesh, double least = 25)
{
    const Quality quality = quality_of(mesh);
    return quality.min_dihedral > least - 0.01 && quality.max_dihedral < greatest_angle(least) + 0.01;
}

// Calls see(point, materials) for each point at which the tetrahedra are of several materials.
template <class See>
void for_interface_points(const LabelledMesh& mesh, const See& see)
{
    std::vector<std::set<Material>> at(mesh.points.size());
    for (size_t t = 0; t < mesh.tets.size(); ++t)
        for (const int32_t v : mesh.tets[t])
            at[static_cast<size_t>(v)].insert(mesh.material[t]);
    for (size_t v = 0; v < at.size(); ++v)
        if (at[v].size() > 1)
            see(mesh.points[v], at[v]);
}

// Indicators value(x, material) on a cube of n voxels, cleaved and improved.
template <class Value>
LabelledMesh improved(int32_t n, int materials, const Value& value, const ImproveOptions& options)
{
    const Grid grid{{n, n, n}, Vec3(1, 1, 1)};
    std::vector<std::vector<double>> fields(static_cast<size_t>(materials));
    Array<const double*> pointers;
    for (int m = 0; m < materials; ++m) {
        for (int32_t i = 0; i < n * n * n; ++i)
            fields[static_cast<size_t>(m)].push_back(value(grid.centre(i % n, i / n % n, i / n / n), m));
        pointers.push_back(fields[static_cast<size_t>(m)].data());
    }
    const Volume volume = Volume::from_indicators(pointers, grid, {}, Run{});
    LabelledMesh mesh = cleave(volume, jittered_bcc(grid.extent(), {n / 2, n / 2, n / 2}, 0.15), {}, Run{});
    improve(mesh, volume, options, Run{});
    return mesh;
}

// Improves the mesh of the case and says whether all that must stay has stayed: validity, the box, the topology of
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
    assert_true(reaches_the_target(c.mesh));
}

static void spheres_and_anisotropic_grains_stay(void**)
{
    Case spheres = cleaved(kissing_spheres(20).labels(), 2);
    assert_true(improve_keeps_all(spheres, {}, 0.01));
    assert_true(reaches_the_target(spheres.mesh));
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
        assert_true(before.below_15 >= 8);
        assert_true(quality_of(c.mesh).min_dihedral > 15);
        assert_true(quality_of(c.mesh).max_dihedral < 160);
    }
}

static void thin_and_tiny_structures_stay(void**)
{
    // Points of more than four materials, or of three in a wall, have no tie to move on.
    const LabelVolume volumes[] = {sheets({12, 12, 12}),    rods({12, 12, 12}),    single_voxel({9, 9, 9}),
                                   checkerboard({8, 8, 8}), noise({16, 16, 1}, 3), single_label({6, 6, 6})};
    for (const LabelVolume& labels : volumes) {
        Case c = cleaved(labels, 1);
        assert_true(improve_keeps_all(c, {}, 0.1));
        assert_true(quality_of(c.mesh).min_dihedral > 15);
        assert_true(quality_of(c.mesh).max_dihedral < 160);
    }
}

static void hopeless_targets_are_survived(void**)
{
    Case c = cleaved(voronoi_grains({8, 8, 8}, 4), 2);
    ImproveOptions options;
    options.min_angle = 45;
    options.effort = Effort::best;
    assert_true(improve_keeps_all(c, options, 0.2));
}

static void points_stay_on_a_sphere(void**)
{
    const Vec3 centre(12.2, 11.9, 12.1);
    for (const Effort effort : {Effort::fast, Effort::best}) {
        ImproveOptions options;
        options.effort = effort;
        const LabelledMesh mesh = improved(
            24, 1, [&](const Vec3& x, int) { return 8.3 - (x - centre).norm(); }, options);
        double sum = 0, worst = 0;
        int count = 0;
        for_interface_points(mesh, [&](const Vec3& x, const std::set<Material>&) {
            const double off = std::abs((x - centre).norm() - 8.3);
            sum += off;
            worst = std::max(worst, off);
            ++count;
        });
        assert_true(count > 200);
        assert_true(sum / count < 0.02);
        assert_true(worst < 0.1);
        assert_true(reaches_the_target(mesh));
    }
}

// Three sectors around a slanted line. Cleaving puts points near the line; improving takes them no further away, but
// for the few that give way to angles, by 0.2 voxels at most.
static void points_stay_on_a_triple_line(void**)
{
    const Vec3 along = Vec3(0.2, -0.1, 1).normalized();
    const Vec3 first = along.unitOrthogonal(), second = along.cross(first);
    const Vec3 middle(10, 10, 10);
    const auto value = [&](const Vec3& x, int m) {
        return (x - middle).dot(std::cos(2.1 * m) * first + std::sin(2.1 * m) * second);
    };
    double mean[2], worst[2];
    for (const bool improve_it : {false, true}) {
        ImproveOptions options;
        options.effort = improve_it ? Effort::fast : Effort::off;
        const LabelledMesh mesh = improved(20, 3, value, options);
        int count = 0;
        double sum = 0, most = 0;
        for_interface_points(mesh, [&](const Vec3& x, const std::set<Material>& materials) {
            if (materials.size() < 3)
                return;
            const double off = (x - middle).cross(along).norm();
            sum += off;
            most = std::max(most, off);
            ++count;
        });
        assert_true(count > 10);
        mean[improve_it] = sum / count;
        worst[improve_it] = most;
        assert_true(!improve_it || reaches_the_target(mesh));
    }
    assert_true(mean[1] < mean[0] + 0.02);
    assert_true(worst[1] <= worst[0] + 0.2);
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
        cmocka_unit_test(points_stay_on_a_sphere),
        cmocka_unit_test(points_stay_on_a_triple_line),
        cmocka_unit_test(off_changes_nothing),
        cmocka_unit_test(the_same_bytes_every_time),
        cmocka_unit_test(notes_tell_before_and_after),
        cmocka_unit_test(a_cancel_is_seen),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
