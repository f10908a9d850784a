// Three sectors that meet in a straight line: their triple points come to lie on it.
#include "support/cmocka.hpp"
#include "support/random.hpp"
#include "support/runs.hpp"

#include "background/lattice.hpp"
#include "checking/validate.hpp"
#include "cleaving/cleave.hpp"
#include "fitting/relocate_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>

using namespace cleft;

namespace
{

constexpr int32_t kSide = 16;
const Vec3 kOnLine(7.7, 8.2, 8.1);
const Vec3 kAxis = Vec3(0.3, -0.2, 1).normalized();

// The indicator of a sector grows along its middle, across the line.
Volume three_sectors()
{
    const Grid grid{{kSide, kSide, kSide}, Vec3(1, 1, 1)};
    const Vec3 u = kAxis.cross(Vec3(1, 0, 0)).normalized(), v = kAxis.cross(u);
    std::array<std::vector<double>, 3> fields;
    for (size_t sector = 0; sector < 3; ++sector) {
        const double angle = 0.4 + 2 * M_PI * static_cast<double>(sector) / 3;
        const Vec3 middle = std::cos(angle) * u + std::sin(angle) * v;
        for (int32_t k = 0; k < kSide; ++k)
            for (int32_t j = 0; j < kSide; ++j)
                for (int32_t i = 0; i < kSide; ++i)
                    fields[sector].push_back(middle.dot(grid.centre(i, j, k) - kOnLine));
    }
    return Volume::from_indicators(std::vector<const double*>{fields[0].data(), fields[1].data(), fields[2].data()},
                                   grid, {}, Run());
}

struct Distances {
    double mean = 0, greatest = 0;
    int count = 0;
};

// From the line, of the points where the three materials meet.
Distances distances_of(const LabelledMesh& mesh)
{
    std::vector<unsigned> materials(mesh.points.size(), 0);
    for (size_t t = 0; t < mesh.tets.size(); ++t)
        for (const int32_t v : mesh.tets[t])
            materials[static_cast<size_t>(v)] |= 1u << mesh.material[t];
    Distances out;
    for (size_t v = 0; v < materials.size(); ++v)
        if (materials[v] == 7) {
            const double distance = kAxis.cross(mesh.points[v] - kOnLine).norm();
            out.mean += distance;
            out.greatest = std::max(out.greatest, distance);
            ++out.count;
        }
    out.mean /= out.count;
    return out;
}

// Walls included: the line leaves through two of them.
void triple_points_of_every_rule_come_to_the_line(void**)
{
    const Volume volume = three_sectors();
    for (const Snap rule : {Snap::none, Snap::quality}) {
        LabelledMesh mesh = cleave(volume, lattice_background(volume.grid(), 1.5, Run()), {rule}, Run());
        const Distances before = distances_of(mesh);
        LocalMesh local(std::move(mesh), Run());
        const int64_t left =
            relocate_lines(local, volume, rule == Snap::none ? 1e-3 : 0.2, find_meetings(local, Run()), Run()).off;
        mesh = local.take(Run());
        const Distances after = distances_of(mesh);
        assert_true(before.count > 10 && after.count == before.count);
        assert_true(left <= before.count);
        assert_true(after.mean <= before.mean && after.greatest <= before.greatest);
        // Some have slivers around, which do not let them go all the way.
        assert_true(after.mean < 0.4 * before.mean);
        const Validation found = validate(mesh, true, Run());
        assert_string_equal(found.first_fault.c_str(), "");
        assert_true(std::abs(found.volume - kSide * kSide * kSide) < 1e-6);
    }
}

void no_point_moves_where_shapes_would_suffer(void**)
{
    const Volume volume = three_sectors();
    LabelledMesh mesh = cleave(volume, lattice_background(volume.grid(), 1.5, Run()), {Snap::none}, Run());
    LocalMesh local(std::move(mesh), Run());
    std::vector<double> before;
    for (int32_t t = 0; t < local.slot_count(); ++t)
        before.push_back(local.quality(t));
    constexpr double kFloor = 0.3;
    relocate_lines(local, volume, kFloor, find_meetings(local, Run()), Run());
    double least_before = 1, least_after = 1;
    for (int32_t t = 0; t < local.slot_count(); ++t) {
        least_before = std::min(least_before, before[static_cast<size_t>(t)]);
        least_after = std::min(least_after, local.quality(t));
        if (local.quality(t) < before[static_cast<size_t>(t)] && local.quality(t) < kFloor)
            assert_true(local.quality(t) >= least_before);
    }
    assert_true(least_after >= least_before);
}

// Those of a part of a larger mesh that had their turn before.
void settled_points_stay(void**)
{
    const Volume volume = three_sectors();
    LocalMesh local(cleave(volume, lattice_background(volume.grid(), 1.5, Run()), {Snap::none}, Run()), Run());
    const auto before = local.points();
    Array<int32_t> settled;
    for (int32_t t = 0; t < local.slot_count(); ++t)
        if (before[local.tet(t)[0]][2] < 0.5 * kSide)
            settled.push_back(t);
    local.settle(settled);
    relocate_lines(local, volume, 1e-3, find_meetings(local, Run()), Run());
    int moved = 0;
    for (int32_t v = 0; v < local.point_count(); ++v) {
        moved += local.point(v) != before[v];
        assert_true(!local.is_settled(v) || local.point(v) == before[v]);
    }
    assert_true(moved > 3);
}

// Cells of random seeds, whose walls meet in many lines.
constexpr int32_t kBox = 24;

Volume grains()
{
    constexpr size_t kSeeds = 60;
    const Grid grid{{kBox, kBox, kBox}, Vec3(1, 1, 1)};
    cleft_test::Random random(7);
    std::vector<std::vector<double>> fields(kSeeds);
    Array<const double*> all;
    for (auto& field : fields) {
        const Vec3 seed = kBox * Vec3{random.unit(), random.unit(), random.unit()};
        for (int32_t k = 0; k < kBox; ++k)
            for (int32_t j = 0; j < kBox; ++j)
                for (int32_t i = 0; i < kBox; ++i)
                    field.push_back(-(grid.centre(i, j, k) - seed).norm());
        all.push_back(field.data());
    }
    return Volume::from_indicators(all, grid, {}, Run());
}

// Where the mesh around makes room, with contractions too.
void looking_around_gives_one_mesh_for_any_threads(void**)
{
    const Volume volume = grains();
    const LabelledMesh cleaved = cleave(volume, lattice_background(volume.grid(), 0.7, Run()), {Snap::quality}, Run());
    LabelledMesh first;
    for (const int threads : {1, 2, 5}) {
        const Run run = cleft_test::with_threads(threads);
        LocalMesh local(LabelledMesh(cleaved), run);
        const Meetings meetings = find_meetings(local, run);
        const int64_t lines = std::count(meetings.begin(), meetings.end(), Meeting::line);
        const LinePoints left = relocate_lines(local, volume, 0.26, meetings, run, true);
        const LabelledMesh mesh = local.take(run);
        assert_true(lines > 2000 && left.off < lines / 4);
        assert_true(mesh.points.size() < cleaved.points.size());
        const Validation found = validate(mesh, true, run);
        assert_string_equal(found.first_fault.c_str(), "");
        assert_true(std::abs(found.volume - kBox * kBox * kBox) < 1e-6);
        if (threads == 1)
            first = mesh;
        assert_true(mesh.points == first.points && mesh.tets == first.tets && mesh.material == first.material);
    }
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(triple_points_of_every_rule_come_to_the_line),
        cmocka_unit_test(no_point_moves_where_shapes_would_suffer),
        cmocka_unit_test(settled_points_stay),
        cmocka_unit_test(looking_around_gives_one_mesh_for_any_threads),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
