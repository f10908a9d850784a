// What becomes of the pieces of a label: those one voxel thick come out whole if that is asked for, and the report
// shows which grew together.
#include "support/cmocka.hpp"
#include "support/meshing.hpp"

using namespace cleft_test;

namespace
{

const Dims kDims = {20, 20, 20};

LabelVolume plane_of(double from, double to)
{
    return make_labels(kDims, [&](int32_t i, int32_t j, int32_t k) {
        const double height = 0.36 * i - 0.48 * j + 0.8 * k - 7;
        return height >= from && height < to;
    });
}

// Branches of voxels that hang together over faces, away from the walls.
LabelVolume random_tree(uint64_t seed)
{
    Random random(seed);
    LabelVolume tree = single_label(kDims, 0);
    const std::array<size_t, 3> step = {1, 20, 400};
    for (int branch = 0; branch < 6; ++branch) {
        std::array<int32_t, 3> at = {10, 10, 10};
        for (int turn = 0; turn < 5; ++turn) {
            const size_t axis = random.below(3);
            const int32_t way = random.below(2) ? 1 : -1;
            for (int n = 0; n < 4 && at[axis] + way > 1 && at[axis] + way < 18; ++n) {
                at[axis] += way;
                tree.voxels[static_cast<size_t>(at[0]) * step[0] + static_cast<size_t>(at[1]) * step[1] +
                            static_cast<size_t>(at[2]) * step[2]] = 1;
            }
        }
    }
    return tree;
}

// Single voxels and pairs, far from each other.
LabelVolume specks()
{
    return make_labels(kDims, [](int32_t i, int32_t j, int32_t k) {
        return i % 6 == 3 && j % 6 == 3 && (k % 6 == 3 || (k % 6 == 4 && i > 6));
    });
}

// Two slabs and a gap of one voxel, which is the thin part.
LabelVolume gap()
{
    return make_labels(kDims, [](int32_t i, int32_t, int32_t) { return i > 5 && i < 15 && i != 10; });
}

// Columns that touch over edges: 20 diagonal neighbours.
LabelVolume diagonal_columns()
{
    return make_labels({20, 20, 40}, [](int32_t i, int32_t j, int32_t) { return i == j; });
}

OptionTexts with(const char* background, const char* keep_thin)
{
    return {{"background", background}, {"keep_thin", keep_thin}, {"improve", "off"}};
}

bool is_whole(const Meshed& mesh)
{
    for (const cleft_label_report& row : mesh.rows)
        if (row.mesh_components != row.voxel_components || row.large_components_broken + row.large_components_lost > 0)
            return false;
    return mesh.failure.empty() && !mesh.rows.empty();
}

}  // namespace

static void parts_of_one_voxel_are_kept(void**)
{
    std::vector<LabelVolume> volumes = {plane_of(0, 1.2), sheets(kDims), rods(kDims), specks(), gap()};
    for (uint64_t seed = 1; seed <= 5; ++seed)
        volumes.push_back(random_tree(seed));
    for (const LabelVolume& labels : volumes)
        for (const char* background : {"particles", "octree"})
            assert_true(is_whole(mesh_of(labels, with(background, "true"))));
    assert_true(is_whole(mesh_of(random_tree(6), with("lattice", "true"))));
}

static void without_it_some_are_not(void**)
{
    int whole = 0;
    for (uint64_t seed = 1; seed <= 5; ++seed)
        whole += is_whole(mesh_of(random_tree(seed), with("particles", "false"))) &&
                 is_whole(mesh_of(random_tree(seed), with("octree", "false")));
    assert_true(whole < 5);
}

static void all_else_is_as_it_was(void**)
{
    const LabelVolume thick = plane_of(0, 4);
    for (const char* background : {"particles", "octree", "lattice"}) {
        const Meshed plain = mesh_of(thick, with(background, "false")), kept = mesh_of(thick, with(background, "true"));
        assert_string_equal((plain.failure + kept.failure).c_str(), "");
        assert_true(plain.tets == kept.tets && plain.labels == kept.labels);
    }
    // A speck is refined for, and the rest of the box is not.
    const Meshed speck = mesh_of(single_voxel(kDims), with("octree", "true"));
    const Meshed plain = mesh_of(single_voxel(kDims), with("octree", "false"));
    assert_true(speck.tets.size() > plain.tets.size());
    assert_true(speck.tets.size() < 12 * plain.tets.size());
}

static void an_own_least_size_holds(void**)
{
    OptionTexts options = with("octree", "true");
    options.emplace_back("size_min", "1");
    const Meshed bounded = mesh_of(random_tree(1), options);
    assert_string_equal(bounded.failure.c_str(), "");
    assert_true(bounded.metric("sizing.least") >= 1);
}

static void pieces_that_grew_together_are_told(void**)
{
    for (const char* background : {"particles", "octree"}) {
        const Meshed joined = mesh_of(diagonal_columns(), with(background, "false"));
        assert_string_equal(joined.failure.c_str(), "");
        assert_int_equal(joined.rows[1].large_components, 20);
        assert_true(joined.rows[1].mesh_components < 20);
        assert_true(joined.rows[1].large_components_joined >= 2 && joined.rows[1].large_components_joined <= 20);
        const Meshed apart = mesh_of(gap(), with(background, "false"));
        assert_int_equal(apart.rows[1].large_components, 2);
        assert_int_equal(apart.rows[0].large_components_joined + apart.rows[1].large_components_joined, 0);
    }
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(parts_of_one_voxel_are_kept),
        cmocka_unit_test(without_it_some_are_not),
        cmocka_unit_test(all_else_is_as_it_was),
        cmocka_unit_test(an_own_least_size_holds),
        cmocka_unit_test(pieces_that_grew_together_are_told),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
