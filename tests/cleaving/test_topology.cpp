// Thin parts stay whole, and the interface of two materials stays a manifold.
#include "pipeline/label_report.hpp"
#include "pipeline/pipeline.hpp"
#include "sizing/volume_sizing.hpp"
#include "support/cmocka.hpp"
#include "support/pinches.hpp"
#include "support/topology.hpp"
#include "support/volumes.hpp"

using namespace cleft;
using namespace cleft_test;

namespace
{

constexpr int32_t kSide = 26;
const BackgroundKind kGraded[] = {BackgroundKind::particles, BackgroundKind::octree};

// Label 1 where inside(x) holds, with x from the middle of the box.
template <class Inside>
LabelVolume part(const Inside& inside)
{
    return make_labels({kSide, kSide, kSide}, [&](int32_t i, int32_t j, int32_t k) {
        return inside(Vec3(i + 0.5, j + 0.5, k + 0.5) - Vec3::Constant(kSide / 2.0)) ? 1 : 0;
    });
}

LabelVolume plate(const Vec3& normal, double from, double to)
{
    return part([&](const Vec3& x) { return x.dot(normal) >= from && x.dot(normal) < to; });
}

LabelVolume shell(double radius)
{
    const Vec3 centre(0.2, 0.3, 0.1);
    return part([&](const Vec3& x) { return std::abs((x - centre).norm() - radius) < 1; });
}

LabelledMesh meshed(const LabelVolume& labels, const PipelineOptions& options)
{
    const Grid grid{{labels.dims}, Vec3(1, 1, 1)};
    const Volume volume = Volume::from_labels(VoxelType::uint8, labels.voxels.data(), grid, 5, Run());
    return mesh_from_sizing(volume, {compute_sizing(volume, options.sizing, Run())}, options, Run());
}

// The parts and Euler numbers of the two labels.
struct Shape {
    std::vector<size_t> parts;
    std::vector<int64_t> euler;
};

bool comes_out_as(const LabelVolume& labels, const Shape& shape)
{
    for (const BackgroundKind kind : kGraded) {
        PipelineOptions options;
        options.background.kind = kind;
        const LabelledMesh mesh = meshed(labels, options);
        const Topology topology = topology_of(mesh, 2);
        if (topology.parts != shape.parts || topology.euler != shape.euler ||
            count_pinches(mesh.tets, mesh.material).edges != 0)
            return false;
    }
    return true;
}

const Vec3 kDirections[] = {
    Vec3(1, 0, 0),
    Vec3(0, 0, 1),
    Vec3(1, 1, 0) / std::sqrt(2),
    Vec3(0.36, -0.48, 0.8),
    Vec3(0.6, 0.64, 0.48),
    Vec3(0.92, 0.24, -0.31).normalized(),
    Vec3(0.1, 0.7, 0.7).normalized(),
};

}  // namespace

static void sheets_of_two_voxels_stay_whole(void**)
{
    for (const Vec3& normal : kDirections)
        assert_true(comes_out_as(plate(normal, -1, 1), {{2, 1}, {2, 1}}));
}

static void gaps_of_two_voxels_stay_open(void**)
{
    for (const Vec3& normal : kDirections) {
        const auto slabs = [&](const Vec3& x) {
            const double height = std::abs(x.dot(normal));
            return height > 1 && height < 6;
        };
        assert_true(comes_out_as(part(slabs), {{3, 2}, {3, 2}}));
    }
}

static void curved_shells_of_two_voxels_stay_whole(void**)
{
    for (const double radius : {5.0, 9.5})
        assert_true(comes_out_as(shell(radius), {{2, 1}, {3, 2}}));
}

// Two balls two voxels apart.
static void near_balls_stay_apart(void**)
{
    const auto balls = [](const Vec3& x) {
        return (x - Vec3(0.5, 0.5, 6.5)).norm() < 5.2 || (x - Vec3(0.5, 0.5, -6)).norm() < 5.2;
    };
    assert_true(comes_out_as(part(balls), {{1, 2}, {3, 2}}));
}

// A curve of voxels that touch by faces, one voxel thick: edges of half a voxel keep it, those of two and a half break
// it and those of six lose it, and then the report says so.
static void half_a_voxel_keeps_what_is_one_thick(void**)
{
    LabelVolume labels = part([](const Vec3&) { return false; });
    Vec3 at(4.5, 12.5, 12.5);
    for (int step = 0; step < 60; ++step) {
        const auto k = static_cast<size_t>(at[2]), j = static_cast<size_t>(at[1]), i = static_cast<size_t>(at[0]);
        labels.voxels[i + kSide * (j + kSide * k)] = 1;
        at[step % 3] += step % 3 == 0 ? 1 : (step / 18 % 2 == 0 ? 1 : -1) * (step % 3 == 1 ? 1 : 0.5);
        at = at.cwiseMin(kSide - 3.5).cwiseMax(3.5);
    }
    const Volume volume =
        Volume::from_labels(VoxelType::uint8, labels.voxels.data(), {{labels.dims}, Vec3(1, 1, 1)}, 5, Run());
    for (const BackgroundKind kind : kGraded) {
        PipelineOptions options;
        options.background.kind = kind;
        options.sizing.size_min = 0.5;
        const std::vector<LabelRow> rows = label_report(volume, meshed(labels, options), Run()).rows;
        assert_true(rows[1].voxels > 30);
        assert_int_equal(rows[1].mesh_components, rows[1].voxel_components);
        assert_int_equal(rows[1].large_components_lost + rows[1].large_components_broken, 0);
        for (const double size : {2.5, 6.0}) {
            options.sizing.size_min = options.sizing.size = size;
            const LabelRow coarse = label_report(volume, meshed(labels, options), Run()).rows[1];
            assert_true(coarse.large_components_lost + coarse.large_components_broken > 0);
            PipelineOptions strict = options;
            strict.strict = true;
            cleft_status status = CLEFT_OK;
            try {
                meshed(labels, strict);
            } catch (const Error& error) {
                status = error.status();
            }
            assert_int_equal(status, CLEFT_ERROR_LABEL_LOST);
        }
    }
}

static void unsnapped_interfaces_are_manifold(void**)
{
    PipelineOptions options;
    options.cleave.snap = Snap::none;
    options.improve.effort = Effort::off;
    const LabelVolume volumes[] = {noise({10, 10, 10}, 2), noise({10, 10, 10}, 5), checkerboard({8, 8, 8}),
                                   sheets({12, 12, 12}), voronoi_grains({20, 20, 20}, 9)};
    for (const LabelVolume& labels : volumes) {
        const LabelledMesh mesh = meshed(labels, options);
        const Pinches pinches = count_pinches(mesh.tets, mesh.material);
        assert_int_equal(pinches.edges + pinches.points, 0);
    }
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(sheets_of_two_voxels_stay_whole),        cmocka_unit_test(gaps_of_two_voxels_stay_open),
        cmocka_unit_test(curved_shells_of_two_voxels_stay_whole), cmocka_unit_test(near_balls_stay_apart),
        cmocka_unit_test(half_a_voxel_keeps_what_is_one_thick),   cmocka_unit_test(unsnapped_interfaces_are_manifold),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
