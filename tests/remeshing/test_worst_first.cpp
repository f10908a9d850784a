// The order of work of a search, and the figures on its angles: the same for every number of threads, and what a plain
// pass over the tetrahedra says.
#include "mesh/quality.hpp"
#include "remeshing/angle_notes.hpp"
#include "remeshing/worst_first.hpp"
#include "support/bcc.hpp"
#include "support/cmocka.hpp"
#include "support/runs.hpp"

#include <algorithm>
#include <tuple>

using namespace cleft;
using namespace cleft_test;

namespace
{

constexpr double kTarget = 0.6;

// Of several chunks, with angles of all kinds.
const TetMesh& box()
{
    static const TetMesh mesh = jittered_bcc(Vec3(18, 16, 12), {18, 16, 12}, 0.2);
    return mesh;
}

LocalMesh local(const Run& run) { return LocalMesh(box().points, box().tets, {}, run); }

Array<int32_t> listed(const WorstFirst& bad)
{
    Array<int32_t> tets;
    for (size_t i = 0; i < bad.size(); ++i)
        tets.push_back(bad[i]);
    return tets;
}

// Those of some tetrahedra that are below the target, the worst first.
Array<int32_t> worst_first(const LocalMesh& mesh, Array<int32_t> tets)
{
    tets.erase(std::remove_if(tets.begin(), tets.end(), [&](int32_t t) { return mesh.quality(t) >= kTarget; }),
               tets.end());
    std::sort(tets.begin(), tets.end(), [&](int32_t a, int32_t b) {
        return std::make_tuple(mesh.quality(a), a) < std::make_tuple(mesh.quality(b), b);
    });
    return tets;
}

void all_bad_ones_are_listed(void**)
{
    for (const int threads : {1, 2, 5}) {
        const Run run = with_threads(threads);
        const LocalMesh mesh = local(run);
        assert_true(mesh.slot_count() > 1 << 15);
        Array<int32_t> all;
        for (int32_t t = 0; t < mesh.slot_count(); ++t)
            all.push_back(t);
        WorstFirst bad;
        bad.collect_all(mesh, kTarget, run);
        assert_true(bad.size() > 100);
        assert_true(listed(bad) == worst_first(mesh, all));
    }
}

// A tetrahedron that is named twice comes once, and knows of the last try.
void the_next_pass_has_each_once(void**)
{
    const Run run = with_threads(2);
    const LocalMesh mesh = local(run);
    WorstFirst bad;
    bad.collect_all(mesh, kTarget, run);
    const int32_t first = bad[0], second = bad[1];
    bad.changed(mesh, {second, first, second});
    bad.give_back(0, true);
    bad.give_back(1, false);
    bad.collect_next(mesh, kTarget);
    assert_true(listed(bad) == worst_first(mesh, {first, second}));
    assert_false(bad.worth_trying(mesh, 0, kTarget));
    assert_true(bad.worth_trying(mesh, 1, kTarget));
    // Another search tries all that are left again.
    bad.collect_left(mesh, kTarget);
    assert_true(listed(bad) == worst_first(mesh, {first, second}));
    assert_true(bad.worth_trying(mesh, 0, kTarget) && bad.worth_trying(mesh, 1, kTarget));
}

// Where a mesh was cut out of a larger one, searches for better shapes can wait until it is whole again.
void tetrahedra_at_a_cut_can_wait(void**)
{
    const Run run = with_threads(2);
    for (const bool until_whole : {false, true}) {
        LocalMesh mesh = local(run);
        Array<int32_t> held, open;
        for (int32_t v = 0; v < mesh.point_count(); v += 7)
            held.push_back(v);
        for (int32_t t = 0; t < mesh.slot_count(); ++t) {
            const Tet& tet = mesh.tet(t);
            const bool is_at_cut = std::any_of(tet.begin(), tet.end(), [](int32_t v) { return v % 7 == 0; });
            if (!is_at_cut || !until_whole)
                open.push_back(t);
        }
        mesh.hold(held, until_whole);
        WorstFirst bad;
        bad.collect_all(mesh, kTarget, run);
        assert_true(bad.size() > 100);
        assert_true(listed(bad) == worst_first(mesh, open));
    }
}

void figures_are_those_of_all_angles(void**)
{
    double least = 180, greatest = 0, below_30 = 0;
    for (const Tet& t : box().tets) {
        const auto angles =
            dihedral_angles(box().points[t[0]], box().points[t[1]], box().points[t[2]], box().points[t[3]]);
        const auto [low, high] = std::minmax_element(angles.begin(), angles.end());
        least = std::min(least, *low);
        greatest = std::max(greatest, *high);
        below_30 += *low < 30;
    }
    for (const int threads : {1, 2, 5}) {
        Metrics metrics;
        Run run = with_threads(threads);
        run.metrics = &metrics;
        note_angles(local(run), "box", "now", run);
        assert_true(metrics.get("box.tets_now") == static_cast<double>(box().tets.size()));
        assert_true(metrics.get("box.min_angle_now") == least);
        assert_true(metrics.get("box.max_angle_now") == greatest);
        assert_true(metrics.get("box.below_30_now") == below_30);
    }
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(all_bad_ones_are_listed),
        cmocka_unit_test(the_next_pass_has_each_once),
        cmocka_unit_test(tetrahedra_at_a_cut_can_wait),
        cmocka_unit_test(figures_are_those_of_all_angles),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
