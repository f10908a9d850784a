// Cleaving of generated volumes: every output is valid, fills its box and keeps the labels that the cells resolve.
#include "base/error.hpp"
#include "checking/validate.hpp"
#include "cleaving/cleave.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/quality.hpp"
#include "support/bcc.hpp"
#include "support/cmocka.hpp"
#include "support/volumes.hpp"

#include <set>
#include <string>

using namespace cleft;
using namespace cleft_test;

namespace
{

Volume from_labels(const LabelVolume& labels, const Vec3& spacing = Vec3(1, 1, 1))
{
    Grid grid;
    grid.dims = labels.dims;
    grid.spacing = spacing;
    return Volume::from_labels(VoxelType::uint8, labels.voxels.data(), grid, 5, Run());
}

Volume from_distances(const Scene& scene)
{
    Grid grid;
    grid.dims = scene.dims;
    std::vector<std::vector<float>> fields = {scene.outside_distance<float>()};
    for (size_t s = 0; s < scene.solids.size(); ++s)
        fields.push_back(scene.signed_distance<float>(s));
    Array<const float*> pointers;
    for (const auto& field : fields)
        pointers.push_back(field.data());
    return Volume::from_indicators(pointers, grid, {}, Run());
}

// Cells of `cell` smallest spacings.
TetMesh lattice(const Volume& volume, double cell, double jitter)
{
    const Vec3 extent = volume.grid().extent();
    std::array<int32_t, 3> cells{};
    for (size_t axis = 0; axis < 3; ++axis)
        cells[axis] = std::max(1, static_cast<int32_t>(std::lround(extent[static_cast<Eigen::Index>(axis)] /
                                                                   (cell * volume.grid().spacing.minCoeff()))));
    return jittered_bcc(extent, cells, jitter, 5);
}

struct Case {
    std::string name;
    Volume volume;
    double cell;
};

std::vector<Case> all_cases()
{
    std::vector<Case> cases;
    cases.push_back({"kissing spheres", from_labels(kissing_spheres(12).labels()), 1.5});
    cases.push_back({"kissing spheres as distances", from_distances(kissing_spheres(12)), 1.5});
    cases.push_back({"two sizes", from_labels(two_sizes(14).labels()), 1.5});
    cases.push_back({"torus", from_labels(ring(16).labels()), 1.5});
    cases.push_back({"grains", from_labels(voronoi_grains({16, 14, 12}, 8)), 1.5});
    cases.push_back({"grains, cells as voxels", from_labels(voronoi_grains({8, 8, 8}, 5)), 1});
    cases.push_back({"noise", from_labels(noise({6, 6, 6}, 5)), 1});
    cases.push_back({"noise, many labels", from_labels(noise({4, 4, 4}, 60)), 1.2});
    cases.push_back({"noise, large cells", from_labels(noise({9, 9, 9}, 40)), 3});
    cases.push_back({"checkerboard", from_labels(checkerboard({7, 7, 7})), 1});
    cases.push_back({"checkerboard of blocks", from_labels(checkerboard({10, 10, 10}, 4)), 1});
    cases.push_back({"sheets", from_labels(sheets({7, 7, 7})), 0.7});
    cases.push_back({"rods", from_labels(rods({7, 7, 7})), 0.7});
    cases.push_back({"single voxel", from_labels(single_voxel({5, 5, 5})), 0.7});
    cases.push_back({"single label", from_labels(single_label({6, 6, 6})), 1});
    cases.push_back({"one voxel thick", from_labels(voronoi_grains({12, 12, 1}, 5)), 1});
    cases.push_back({"one voxel", from_labels(single_label({1, 1, 1})), 1});
    cases.push_back({"anisotropic", from_labels(voronoi_grains({16, 16, 4}, 6), Vec3(0.5, 0.5, 3)), 2});
    cases.push_back({"tiny spacing", from_labels(voronoi_grains({8, 8, 8}, 4), Vec3(1e-6, 1e-6, 2e-6)), 1.5});
    cases.push_back({"huge spacing", from_labels(noise({6, 6, 6}, 3), Vec3(1e6, 2e6, 1e6)), 1.5});
    return cases;
}

const Snap kRules[] = {Snap::quality, Snap::safe, Snap::none};

LabelledMesh cleaved(const Volume& volume, const TetMesh& background, Snap rule, int threads = 1)
{
    Run run;
    run.threads = threads;
    CleaveOptions options;
    options.snap = rule;
    return cleave(volume, background, options, run);
}

// The first thing wrong with a mesh of the whole box of a volume, or nothing.
std::string fault_of(const LabelledMesh& mesh, const Volume& volume)
{
    const Validation v = validate(mesh, true, Run());
    if (!v.valid())
        return v.first_fault;
    const Vec3 extent = volume.grid().extent();
    Vec3 low = mesh.points[0], high = low;
    for (const Vec3& p : mesh.points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    if (low != Vec3(0, 0, 0) || high != extent)
        return "the mesh does not end where the box ends";
    if (std::abs(v.volume / extent.prod() - 1) > 1e-9)
        return "the volume is not that of the box";
    for (const Material m : mesh.material)
        if (m < 0 || m >= volume.material_count())
            return "a material is not one of the volume";
    return "";
}

std::string first_fault(double jitter)
{
    for (const Case& c : all_cases())
        for (const Snap rule : kRules) {
            const TetMesh background = lattice(c.volume, c.cell, jitter);
            const std::string fault = fault_of(cleaved(c.volume, background, rule), c.volume);
            if (!fault.empty())
                return c.name + ", snap " + std::to_string(static_cast<int>(rule)) + ": " + fault;
        }
    return "";
}

void jittered_backgrounds_give_valid_meshes(void**) { assert_string_equal(first_fault(0.1).c_str(), ""); }

void noise_gives_a_valid_mesh(void**)
{
    const Volume volume = from_labels(noise({24, 24, 24}, 5));
    for (const Snap rule : kRules)
        assert_string_equal(fault_of(cleaved(volume, lattice(volume, 2, 0.1), rule), volume).c_str(), "");
}

// Vertices in voxel centres, on voxel faces and exactly on interfaces.
void aligned_backgrounds_give_valid_meshes(void**) { assert_string_equal(first_fault(0).c_str(), ""); }

// A background with slivers: every tenth inner point moves to within 1e-6 of turning a tetrahedron over.
TetMesh with_slivers(TetMesh mesh)
{
    Random random(9);
    std::vector<std::vector<size_t>> around(mesh.points.size());
    for (size_t t = 0; t < mesh.tets.size(); ++t)
        for (const int32_t v : mesh.tets[t])
            around[static_cast<size_t>(v)].push_back(t);
    const std::vector<uint8_t> frozen =
        frozen_axes(mesh.points, mesh.tets, tet_neighbours(mesh.tets, static_cast<int64_t>(mesh.points.size())));
    for (size_t v = 0; v < mesh.points.size(); ++v) {
        if (frozen[v] || random.below(10))
            continue;
        const Vec3 from = mesh.points[v];
        const Vec3 way(random.between(-2, 2), random.between(-2, 2), random.between(-2, 2));
        const auto is_positive_at = [&](double s) {
            mesh.points[v] = from + s * way;
            return std::all_of(around[v].begin(), around[v].end(), [&](size_t t) {
                const auto p = [&](size_t i) { return mesh.points[static_cast<size_t>(mesh.tets[t][i])]; };
                return orient(p(0), p(1), p(2), p(3)) > 1e-9;
            });
        };
        double inside = 0, outside = 4;
        while (outside - inside > 1e-6)
            (is_positive_at((inside + outside) / 2) ? inside : outside) = (inside + outside) / 2;
        is_positive_at(inside);
    }
    return mesh;
}

void backgrounds_with_slivers_give_valid_meshes(void**)
{
    for (const Case& c : all_cases()) {
        if (c.volume.grid().spacing.maxCoeff() > 10 || c.volume.grid().spacing.minCoeff() < 0.1)
            continue;
        const TetMesh background = with_slivers(lattice(c.volume, c.cell, 0.1));
        for (const Snap rule : kRules) {
            const std::string fault = fault_of(cleaved(c.volume, background, rule), c.volume);
            assert_string_equal((fault.empty() ? "" : c.name + ": " + fault).c_str(), "");
        }
    }
}

bool same_bytes(const LabelledMesh& a, const LabelledMesh& b)
{
    return a.points == b.points && a.tets == b.tets && a.material == b.material;
}

void threads_do_not_change_the_mesh(void**)
{
    for (const Case& c : all_cases())
        for (const Snap rule : kRules) {
            const TetMesh background = lattice(c.volume, c.cell, 0.1);
            assert_true(same_bytes(cleaved(c.volume, background, rule, 1), cleaved(c.volume, background, rule, 2)));
        }
}

void every_label_is_kept_by_cells_smaller_than_voxels(void**)
{
    for (const Case& c : all_cases()) {
        if (c.volume.grid().size() > 350)
            continue;
        const TetMesh background = lattice(c.volume, 0.7, 0.05);
        for (const Snap rule : kRules) {
            const LabelledMesh mesh = cleaved(c.volume, background, rule);
            const std::set<Material> kept(mesh.material.begin(), mesh.material.end());
            assert_int_equal(kept.size(), c.volume.material_count());
        }
    }
}

double least_angle(const LabelledMesh& mesh) { return measure_quality(mesh.points, mesh.tets, Run()).min_dihedral; }

void quality_snapping_beats_the_others_on_smooth_surfaces(void**)
{
    const Volume volume = from_distances(kissing_spheres(24));
    const TetMesh background = lattice(volume, 1.5, 0);
    const double quality = least_angle(cleaved(volume, background, Snap::quality)),
                 safe = least_angle(cleaved(volume, background, Snap::safe)),
                 none = least_angle(cleaved(volume, background, Snap::none));
    assert_true(none < safe);
    assert_true(safe < quality);
    assert_true(quality > 15);
}

// A sphere of radius r: the interface lies within a fraction of a voxel of it and the volumes agree.
void interfaces_lie_where_the_functions_tie(void**)
{
    const double radius = 9;
    const Vec3 centre(12, 12, 12);
    Scene scene;
    scene.dims = {24, 24, 24};
    scene.solids = {sphere({12, 12, 12}, radius)};
    const Volume volume = from_distances(scene);
    for (const Snap rule : kRules) {
        const LabelledMesh mesh = cleaved(volume, lattice(volume, 1.5, 0.1), rule);
        std::vector<int> sides(mesh.points.size(), 0);
        double inside = 0;
        for (size_t t = 0; t < mesh.tets.size(); ++t) {
            for (const int32_t p : mesh.tets[t])
                sides[static_cast<size_t>(p)] |= mesh.material[t] ? 2 : 1;
            const auto p = [&](size_t i) { return mesh.points[static_cast<size_t>(mesh.tets[t][i])]; };
            if (mesh.material[t])
                inside += orient(p(0), p(1), p(2), p(3)) / 6;
        }
        int64_t on_surface = 0;
        for (size_t v = 0; v < sides.size(); ++v)
            if (sides[v] == 3) {
                assert_true(std::abs((mesh.points[v] - centre).norm() - radius) < 0.05);
                ++on_surface;
            }
        assert_true(on_surface > 500);
        const double exact = 4.0 / 3 * 3.14159265358979 * radius * radius * radius;
        assert_true(std::abs(inside / exact - 1) < 0.02);
    }
}

void a_cancel_ends_the_run(void**)
{
    const Volume volume = from_labels(noise({12, 12, 12}, 5));
    const TetMesh background = lattice(volume, 1, 0.1);
    for (const int reports : {0, 1, 3, 6}) {
        int count = 0;
        Run run;
        run.progress = [&](double, const char*) { return count++ == reports; };
        cleft_status status = CLEFT_OK;
        try {
            cleave(volume, background, {}, run);
        } catch (const Error& e) {
            status = e.status();
        }
        assert_int_equal(status, CLEFT_ERROR_CANCELLED);
    }
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(jittered_backgrounds_give_valid_meshes),
        cmocka_unit_test(noise_gives_a_valid_mesh),
        cmocka_unit_test(aligned_backgrounds_give_valid_meshes),
        cmocka_unit_test(backgrounds_with_slivers_give_valid_meshes),
        cmocka_unit_test(threads_do_not_change_the_mesh),
        cmocka_unit_test(every_label_is_kept_by_cells_smaller_than_voxels),
        cmocka_unit_test(quality_snapping_beats_the_others_on_smooth_surfaces),
        cmocka_unit_test(interfaces_lie_where_the_functions_tie),
        cmocka_unit_test(a_cancel_ends_the_run),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
