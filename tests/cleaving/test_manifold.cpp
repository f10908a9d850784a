// Where only two labels meet, they meet in surfaces: on every background, of any volume.
#include "support/cmocka.hpp"
#include "support/meshing.hpp"
#include "support/pinches.hpp"

using namespace cleft_test;

namespace
{

const char* const kBackgrounds[] = {"particles", "octree", "lattice"};

// A curve of voxels, each at a face of the one before or, where it may, at an edge or a corner.
LabelVolume random_walk(const Dims& dims, bool over_corners, uint64_t seed)
{
    Random random(seed);
    LabelVolume walk = single_label(dims, 0);
    std::array<int32_t, 3> at = {dims[0] / 2, dims[1] / 2, dims[2] / 2};
    for (int step = 0; step < 150; ++step) {
        const size_t only = random.below(3);
        for (size_t axis = 0; axis < 3; ++axis) {
            const auto move = static_cast<int32_t>(random.below(3)) - 1;
            if (over_corners || axis == only)
                at[axis] = std::clamp(at[axis] + move, 1, dims[axis] - 2);
        }
        walk.voxels[static_cast<size_t>(at[0] + dims[0] * (at[1] + dims[1] * at[2]))] = 1;
    }
    return walk;
}

// One voxel thick, across no axis.
LabelVolume oblique_sheet(const Dims& dims)
{
    return make_labels(dims, [](int32_t i, int32_t j, int32_t k) {
        const double height = 0.36 * i - 0.48 * j + 0.8 * k - 4;
        return std::abs(height) < 0.5;
    });
}

// Two and two cubes that touch in an edge, and in a corner.
LabelVolume touching_cubes(const Dims& dims)
{
    return make_labels(dims, [](int32_t i, int32_t j, int32_t k) { return (i < 6) == (j < 6) && (k < 6 || i < 6); });
}

std::vector<LabelVolume> volumes()
{
    const Dims dims = {12, 12, 12};
    return {noise(dims, 2),
            noise(dims, 3),
            noise(dims, 6),
            checkerboard(dims),
            checkerboard(dims, 2),
            oblique_sheet(dims),
            touching_cubes(dims),
            random_walk(dims, false, 1),
            random_walk(dims, true, 2)};
}

struct Outcome {
    std::string failure;
    Pinches pinches;
    int64_t pinched = 0, left = 0;
    std::vector<int32_t> labels;
};

Outcome outcome_of(const LabelVolume& labels, const char* background, const char* improve)
{
    const Meshed mesh = mesh_of(labels, {{"background", background}, {"improve", improve}, {"min_angle", "25"}});
    return {mesh.failure, count_pinches(mesh.tets, mesh.labels), static_cast<int64_t>(mesh.metric("cleaving.pinched")),
            static_cast<int64_t>(mesh.metric("cleaving.left_pinched")), mesh.labels};
}

}  // namespace

static void no_edge_of_two_labels_is_pinched(void**)
{
    int64_t pinched = 0;
    for (const LabelVolume& labels : volumes())
        for (const char* background : kBackgrounds) {
            const Outcome outcome = outcome_of(labels, background, "fast");
            assert_string_equal(outcome.failure.c_str(), "");
            assert_int_equal(outcome.pinches.edges, 0);
            assert_true(outcome.pinches.points <= outcome.left);
            assert_true(50 * outcome.left <= outcome.pinched);
            pinched += outcome.pinched;
        }
    assert_true(pinched > 1000);  // or there was nothing to mend
}

static void improving_pinches_nothing(void**)
{
    for (const char* background : kBackgrounds) {
        const LabelVolume labels = noise({10, 10, 10}, 2);
        const Outcome before = outcome_of(labels, background, "off"), after = outcome_of(labels, background, "best");
        assert_string_equal((before.failure + after.failure).c_str(), "");
        assert_int_equal(before.pinches.edges + after.pinches.edges, 0);
        assert_int_equal(before.pinches.points, after.pinches.points);
    }
}

// Labels of one voxel each, in noise that has much to mend. (Particles may miss a voxel.)
static void rare_labels_are_kept(void**)
{
    LabelVolume labels = noise({10, 10, 10}, 2);
    for (uint8_t label = 2; label < 8; ++label)
        labels.voxels[label * 111u] = label;
    for (const char* background : {"octree", "lattice"}) {
        const Outcome outcome = outcome_of(labels, background, "off");
        assert_string_equal(outcome.failure.c_str(), "");
        for (int32_t label = 0; label < 8; ++label)
            assert_true(std::count(outcome.labels.begin(), outcome.labels.end(), label) > 0);
    }
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(no_edge_of_two_labels_is_pinched),
        cmocka_unit_test(improving_pinches_nothing),
        cmocka_unit_test(rare_labels_are_kept),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
