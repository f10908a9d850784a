// A pass of a search in rounds: the same mesh for any number of threads, nothing lost, nothing changed twice at once.
#include "mesh/adjacency.hpp"
#include "mesh/quality.hpp"
#include "remeshing/edge_split.hpp"
#include "remeshing/flips.hpp"
#include "remeshing/rounds.hpp"
#include "remeshing/tet_star.hpp"
#include "support/bcc.hpp"
#include "support/cmocka.hpp"
#include "support/runs.hpp"

#include <algorithm>

using namespace cleft;
using namespace cleft_test;

namespace
{

constexpr double kTarget = 0.6;

const TetMesh& box()
{
    static const TetMesh mesh = jittered_bcc(Vec3(12, 10, 8), {12, 10, 8}, 0.22);
    return mesh;
}

// A corner to the middle of its neighbours, or else one of three changes, which depends on the tetrahedron.
int find_any(const LocalMesh& mesh, int32_t t, int step, Proposal& proposal)
{
    for (int corner = step; corner < 4; ++corner) {
        const int32_t v = mesh.tet(t)[corner];
        TetStar star;
        star.load(mesh, v);
        const Vec3 to = star.centroid(mesh.point(v));
        if (mesh.frozen(v) == 0 && star.worst_at(to, -1) > star.worst_at(mesh.point(v), -1) + 1e-3) {
            proposal.set_move(v, to, star.tets());
            return corner + 1;
        }
    }
    Cavity& cavity = proposal.cavity;
    bool found = false;
    if (t % 3 == 0) {
        proposal.kind = Proposal::Kind::edge_removal;
        found = std::any_of(std::begin(kEdgeCorners), std::end(kEdgeCorners),
                            [&](const auto& e) { return find_edge_removal(mesh, t, e[0], e[1], 0, cavity, 0.3); });
    } else if (t % 3 == 1) {
        proposal.kind = Proposal::Kind::face_removal;
        for (int corner = 0; corner < 4 && !found; ++corner)
            found = find_face_removal(mesh, t, corner, cavity, 0.3);
    } else {
        proposal.kind = Proposal::Kind::split;
        mesh.ring(t, 0, 1, cavity.ring);
        proposal.place = 0.5 * (mesh.point(cavity.ring.a) + mesh.point(cavity.ring.b));
        find_split(mesh, cavity);
        found = true;
    }
    if (!found)
        proposal.kind = Proposal::Kind::none;
    return 0;
}

struct Result {
    Array<Vec3> points;
    Array<Tet> tets;
    Array<int64_t> made{0, 0, 0, 0, 0, 0};  // by kind
    int64_t tried = 0;
    Array<int32_t> left;
};

// Some passes of such a search.
Result search(int threads)
{
    const Run run = with_threads(threads);
    LocalMesh mesh(box().points, box().tets, {}, run);
    WorstFirst bad;
    bad.collect_all(mesh, kTarget, run);
    Rounds rounds(mesh, bad);
    Result result;
    for (int pass = 0; pass < 3; ++pass) {
        const auto find = [&](int, int32_t t, int step, Proposal& proposal) {
            return find_any(mesh, t, step, proposal);
        };
        const auto made = [&](const Proposal& p) { ++result.made[static_cast<size_t>(p.kind)]; };
        assert_true(rounds.visit(0, bad.size(), kTarget, find, made, run, 0, 1));
        bad.collect_next(mesh, kTarget);
    }
    for (size_t i = 0; i < bad.size(); ++i)
        result.left.push_back(bad[i]);
    result.tried = rounds.tried();
    // Each list of tetrahedra is that of the corners.
    Array<int32_t> at(mesh.point_count(), 0);
    for (int32_t t = 0; t < mesh.slot_count(); ++t)
        if (mesh.alive(t))
            for (const int32_t v : mesh.tet(t))
                ++at[v];
    for (int32_t v = 0; v < mesh.point_count(); ++v) {
        assert_int_equal(mesh.star(v).size(), at[v]);
        for (const int32_t t : mesh.star(v))
            assert_true(mesh.corner_of(t, v) < 4);
    }
    LabelledMesh taken = mesh.take(run);
    result.points = std::move(taken.points);
    result.tets = std::move(taken.tets);
    return result;
}

void threads_change_nothing(void**)
{
    const Result one = search(1);
    for (const int threads : {2, 3, 8}) {
        const Result more = search(threads);
        assert_true(more.points == one.points);
        assert_true(more.tets == one.tets);
        assert_true(more.made == one.made);
        assert_true(more.left == one.left);
        assert_int_equal(more.tried, one.tried);
    }
}

void changes_fill_the_box(void**)
{
    const Result result = search(3);
    for (const auto kind :
         {Proposal::Kind::move, Proposal::Kind::edge_removal, Proposal::Kind::face_removal, Proposal::Kind::split})
        assert_true(result.made[static_cast<size_t>(kind)] > 20);
    double volume = 0;
    for (const Tet& t : result.tets) {
        const double six = orient(result.points[t[0]], result.points[t[1]], result.points[t[2]], result.points[t[3]]);
        assert_true(six > 0);
        volume += six / 6;
    }
    assert_true(std::abs(volume - 12 * 10 * 8) < 1e-9 * volume);
}

// All want to move the same point: one a round may, the others come again and find the point where it is then.
void who_must_wait_sees_what_was_made(void**)
{
    const Run run = with_threads(2);
    LocalMesh mesh(box().points, box().tets, {}, run);
    int32_t v = 0;
    while (mesh.frozen(v) != 0)
        ++v;
    const Vec3 home = mesh.point(v);
    const int64_t wanted = mesh.star(v).size();
    WorstFirst bad;
    bad.collect_all(mesh, 1, run);
    const auto find = [&](int, int32_t t, int step, Proposal& proposal) {
        if (step == 0 && mesh.corner_of(t, v) < 4) {
            const auto star = mesh.star(v);
            proposal.set_move(v, mesh.point(v) + Vec3(1e-4, 0, 0), Array<int32_t>(star.begin(), star.end()));
        }
        return 1;
    };
    int64_t moves = 0;
    Rounds rounds(mesh, bad);
    assert_true(rounds.visit(
        0, bad.size(), 1, find, [&](const Proposal&) { ++moves; }, run, 0, 1));
    assert_int_equal(moves, wanted);
    assert_true(std::abs((mesh.point(v) - home)[0] - 1e-4 * static_cast<double>(wanted)) < 1e-12);
}

void what_nothing_helps_is_not_tried_again(void**)
{
    const Run run = with_threads(2);
    LocalMesh mesh(box().points, box().tets, {}, run);
    WorstFirst bad;
    bad.collect_all(mesh, kTarget, run);
    const auto count = static_cast<int64_t>(bad.size());
    Rounds rounds(mesh, bad);
    const auto find = [](int, int32_t, int, Proposal&) { return 0; };
    const auto made = [](const Proposal&) { fail(); };
    for (int pass = 0; pass < 2; ++pass) {
        assert_false(rounds.visit(0, bad.size(), kTarget, find, made, run, 0, 1));
        bad.collect_next(mesh, kTarget);
        assert_int_equal(bad.size(), count);
        assert_int_equal(rounds.tried(), count);
    }
    // A part of the list, and nothing of it.
    bad.collect_left(mesh, kTarget);
    assert_false(rounds.visit(5, 25, kTarget, find, made, run, 0, 1));
    assert_int_equal(rounds.tried(), count + 20);
    assert_false(rounds.visit(25, 25, kTarget, find, made, run, 0, 1));
}

void a_cancel_ends_it(void**)
{
    std::atomic<bool> cancel{true};
    Run run = with_threads(2);
    LocalMesh mesh(box().points, box().tets, {}, run);
    WorstFirst bad;
    bad.collect_all(mesh, kTarget, run);
    run.cancel = &cancel;
    Rounds rounds(mesh, bad);
    cleft_status status = CLEFT_OK;
    try {
        rounds.visit(
            0, bad.size(), kTarget, [](int, int32_t, int, Proposal&) { return 0; }, [](const Proposal&) {}, run, 0, 1);
    } catch (const Error& error) {
        status = error.status();
    }
    assert_int_equal(status, CLEFT_ERROR_CANCELLED);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(threads_change_nothing),
        cmocka_unit_test(changes_fill_the_box),
        cmocka_unit_test(who_must_wait_sees_what_was_made),
        cmocka_unit_test(what_nothing_helps_is_not_tried_again),
        cmocka_unit_test(a_cancel_ends_it),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
