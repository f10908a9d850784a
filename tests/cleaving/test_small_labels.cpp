// Labels and parts of a few voxels, rods and sheets of one: snapping must not lose them.
#include "cleaving/cleave.hpp"
#include "pipeline/label_report.hpp"
#include "support/bcc.hpp"
#include "support/cmocka.hpp"
#include "support/volumes.hpp"

#include <set>

using namespace cleft;
using namespace cleft_test;

namespace
{

Volume volume_of(const LabelVolume& labels)
{
    Grid grid;
    grid.dims = labels.dims;
    return Volume::from_labels(VoxelType::uint8, labels.voxels.data(), grid, 5, Run());
}

// Cells of `cell` voxels.
TetMesh lattice(const Volume& volume, double cell, uint64_t seed)
{
    const Vec3 extent = volume.grid().extent();
    std::array<int32_t, 3> cells{};
    for (size_t axis = 0; axis < 3; ++axis)
        cells[axis] = std::max(1, static_cast<int32_t>(std::lround(extent[static_cast<Eigen::Index>(axis)] / cell)));
    return jittered_bcc(extent, cells, 0.1, seed);
}

const Snap kRules[] = {Snap::quality, Snap::safe, Snap::none};

LabelledMesh cleaved(const Volume& volume, const TetMesh& background, Snap rule)
{
    CleaveOptions options;
    options.snap = rule;
    return cleave(volume, background, options, Run());
}

std::set<Material> met_by_vertices(const Volume& volume, const TetMesh& background)
{
    std::set<Material> met;
    for (const Vec3& x : background.points)
        met.insert(volume.material_at(x));
    return met;
}

// Many labels have one vertex only here.
void what_a_vertex_has_met_is_in_the_mesh(void**)
{
    for (uint64_t seed = 1; seed <= 12; ++seed) {
        const Volume volume = volume_of(noise({6, 6, 6}, 100, seed));
        for (const double cell : {1.0, 1.5, 2.5}) {
            const TetMesh background = lattice(volume, cell, seed);
            for (const Snap rule : kRules) {
                const LabelledMesh mesh = cleaved(volume, background, rule);
                const std::set<Material> kept(mesh.material.begin(), mesh.material.end());
                assert_true(kept == met_by_vertices(volume, background));
            }
        }
    }
}

// Pairs of voxels, each a label of its own, in label 0.
LabelVolume pairs()
{
    return make_labels({16, 16, 16}, [](int32_t i, int32_t j, int32_t k) {
        if (i % 4 > 1 || j % 4 != 1 || k % 4 != 1)
            return 0;
        return 1 + i / 4 + 4 * (j / 4) + 16 * (k / 4);
    });
}

std::vector<LabelRow> rows_of(const Volume& volume, Snap rule)
{
    return label_report(volume, cleaved(volume, lattice(volume, 1, 3), rule), Run()).rows;
}

void labels_of_two_voxels_are_kept_by_cells_of_one(void**)
{
    const Volume volume = volume_of(pairs());
    assert_int_equal(volume.material_count(), 65);
    for (const Snap rule : kRules)
        for (const LabelRow& row : rows_of(volume, rule)) {
            assert_true(row.tets > 0);
            // A pair is two cells: corners are cut off, but most of it stays.
            assert_true(row.mesh_volume > 0.3 * row.voxel_volume);
        }
}

// One voxel thick, and larger than what may be lost: a report names what is.
void thin_parts_are_kept(void**)
{
    const LabelVolume hollow = make_labels({12, 12, 12}, [](int32_t i, int32_t j, int32_t k) {
        const int32_t depth = std::min({i, j, k, 11 - i, 11 - j, 11 - k});
        return depth == 3 ? 1 : 0;
    });
    for (const LabelVolume& labels : {sheets({12, 12, 12}), rods({9, 9, 40}), checkerboard({12, 12, 12}, 4), hollow}) {
        const Volume volume = volume_of(labels);
        for (const Snap rule : kRules)
            for (const LabelRow& row : rows_of(volume, rule)) {
                assert_true(row.large_components > 0);
                assert_int_equal(row.large_components_lost, 0);
                assert_true(std::abs(row.mesh_volume / row.voxel_volume - 1) < 0.35);
            }
    }
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(what_a_vertex_has_met_is_in_the_mesh),
        cmocka_unit_test(labels_of_two_voxels_are_kept_by_cells_of_one),
        cmocka_unit_test(thin_parts_are_kept),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
