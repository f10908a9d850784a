// The mesh that local operations work on: it knows what the plain mesh says, and operations can be taken back.
#include "mesh/adjacency.hpp"
#include "mesh/quality.hpp"
#include "remeshing/edge_split.hpp"
#include "remeshing/flips.hpp"
#include "remeshing/tet_star.hpp"
#include "support/bcc.hpp"
#include "support/cmocka.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <cmath>

using namespace cleft;
using namespace cleft_test;

namespace
{

LocalMesh local(const TetMesh& mesh) { return LocalMesh(mesh.points, mesh.tets, {}, Run{}); }

// A box, and a heap of tetrahedra of it whose hull is ragged.
Array<TetMesh> meshes()
{
    TetMesh box = jittered_bcc(Vec3(4, 3, 2), {4, 3, 2}, 0.1);
    TetMesh ragged = box;
    ragged.tets.clear();
    for (size_t t = 0; t < box.tets.size(); t += t % 7 == 0 ? 2 : 1)
        ragged.tets.push_back(box.tets[t]);
    return {box, ragged, {box.points, {box.tets[0]}}};
}

bool knows_its_neighbours(const LocalMesh& mesh, const TetMesh& plain)
{
    const auto neighbours = tet_neighbours(plain.tets, static_cast<int64_t>(plain.points.size()));
    for (int32_t t = 0; t < mesh.slot_count(); ++t)
        for (int corner = 0; corner < 4; ++corner)
            if (mesh.neighbour(t, corner) != neighbours[t][corner])
                return false;
    return true;
}

// Every tetrahedron in the star of each of its corners, and nowhere else.
bool stars_are_right(const LocalMesh& mesh)
{
    int64_t entries = 0, corners = 0;
    for (int32_t v = 0; v < mesh.point_count(); ++v)
        for (const int32_t t : mesh.star(v)) {
            ++entries;
            if (!mesh.alive(t) || mesh.corner_of(t, v) == 4)
                return false;
        }
    for (int32_t t = 0; t < mesh.slot_count(); ++t)
        corners += mesh.alive(t) ? 4 : 0;
    return entries == corners;
}

Array<Tet> sorted_tets(const LocalMesh& mesh)
{
    Array<Tet> tets;
    for (int32_t t = 0; t < mesh.slot_count(); ++t)
        if (mesh.alive(t))
            tets.push_back(mesh.tet(t));
    for (Tet& t : tets)
        std::sort(t.begin(), t.end());
    std::sort(tets.begin(), tets.end());
    return tets;
}

}  // namespace

static void neighbours_and_frozen_axes_are_those_of_the_plain_mesh(void**)
{
    for (const TetMesh& plain : meshes()) {
        const LocalMesh mesh = local(plain);
        assert_true(knows_its_neighbours(mesh, plain));
        assert_true(stars_are_right(mesh));
        const auto neighbours = tet_neighbours(plain.tets, static_cast<int64_t>(plain.points.size()));
        const auto frozen = frozen_axes(plain.points, plain.tets, neighbours);
        for (int32_t v = 0; v < mesh.point_count(); ++v)
            assert_int_equal(mesh.frozen(v), frozen[v]);
    }
}

static void a_tetrahedron_at_two_points_has_both(void**)
{
    for (const TetMesh& plain : meshes()) {
        const LocalMesh mesh = local(plain);
        for (int32_t v = 0; v < mesh.point_count(); ++v)
            for (int32_t w = 0; w < mesh.point_count(); ++w) {
                const auto has_both = [&](const Tet& tet) { return has_corner(tet, v) && has_corner(tet, w); };
                const int32_t t = mesh.tet_at(v, w);
                assert_true(t >= 0 ? has_both(plain.tets[t])
                                   : std::none_of(plain.tets.begin(), plain.tets.end(), has_both));
            }
    }
}

// Two tetrahedra that have an edge in common and no face: neither is all that lies around it.
static void a_ring_tells_where_it_is_not_all(void**)
{
    const TetMesh plain{{Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(-1, 0, 0), Vec3(-1, -1, 0)},
                        {Tet{0, 1, 2, 3}, Tet{0, 1, 4, 5}}};
    LocalMesh mesh = local(plain);
    Cavity cavity;
    EdgeRing ring;
    for (int32_t t = 0; t < 2; ++t) {
        assert_true(mesh.quality(mesh.tet(t)) > 0);
        mesh.ring(t, 0, 1, ring);
        assert_int_equal(ring.tets.size(), 1);
        assert_false(ring.whole);
        assert_false(find_edge_removal(mesh, t, 0, 1, 1, cavity, 0));
        mesh.ring(t, 2, 3, ring);
        assert_true(ring.whole);
    }
}

static void a_ring_goes_round_its_edge(void**)
{
    for (const TetMesh& plain : meshes()) {
        const LocalMesh mesh = local(plain);
        EdgeRing ring;
        for (int32_t t = 0; t < mesh.slot_count(); ++t)
            for (const auto& edge : kEdgeCorners) {
                mesh.ring(t, edge[0], edge[1], ring);
                assert_int_equal(ring.points.size(), ring.tets.size() + (ring.closed ? 0 : 1));
                for (size_t i = 0; i < ring.tets.size(); ++i) {
                    Tet expected{ring.a, ring.b, ring.points[i], ring.points[(i + 1) % ring.points.size()]};
                    assert_true(mesh.quality(expected) > 0);
                    Tet found = mesh.tet(ring.tets[i]);
                    std::sort(expected.begin(), expected.end());
                    std::sort(found.begin(), found.end());
                    assert_true(expected == found);
                }
            }
    }
}

static void an_operation_can_be_taken_back(void**)
{
    const TetMesh plain = jittered_bcc(Vec3(3, 3, 3), {3, 3, 3}, 0.15);
    LocalMesh mesh = local(plain);
    const Array<Tet> before = sorted_tets(mesh);
    Cavity cavity;
    int done = 0;
    for (int32_t t = 0; t < mesh.slot_count(); ++t) {
        if (!mesh.alive(t))
            continue;
        const int operation = t % 3;
        bool changed = true;
        if (operation == 0)
            changed = find_edge_removal(mesh, t, 0, 1, 0, cavity, 0.1);
        else if (operation == 1)
            changed = find_face_removal(mesh, t, 2, cavity, 0.1);
        else {
            mesh.ring(t, 0, 3, cavity.ring);
            find_split(mesh, cavity);
            apply_split(mesh, 0.5 * (mesh.point(cavity.ring.a) + mesh.point(cavity.ring.b)), cavity);
        }
        if (!changed)
            continue;
        if (operation < 2)
            cavity.apply(mesh);
        ++done;
        assert_true(stars_are_right(mesh));
        cavity.undo(mesh);
    }
    assert_true(done > 100);
    assert_true(stars_are_right(mesh));
    assert_true(sorted_tets(mesh) == before);
}

static void what_is_known_of_quality_follows_the_moves(void**)
{
    LocalMesh mesh = local(jittered_bcc(Vec3(2, 2, 2), {2, 2, 2}, 0.1));
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        const auto v = static_cast<int32_t>(random.below(static_cast<uint64_t>(mesh.point_count())));
        mesh.move(v, mesh.point(v) + 0.01 * Vec3(random.unit(), random.unit(), random.unit()));
        for (int32_t t = 0; t < mesh.slot_count(); ++t)
            assert_true(mesh.quality(t) == mesh.quality(mesh.tet(t)));
    }
}

static void bad_corners_are_refused(void**)
{
    const TetMesh plain = jittered_bcc(Vec3(1, 1, 1), {1, 1, 1}, 0);
    for (const int32_t corner : {-1, static_cast<int32_t>(plain.points.size()), plain.tets[0][1]}) {
        TetMesh broken = plain;
        broken.tets[0][0] = corner;
        cleft_status status = CLEFT_OK;
        try {
            local(broken);
        } catch (const Error& error) {
            status = error.status();
        }
        assert_int_equal(status, CLEFT_ERROR_INVALID_MESH);
    }
}

static void quality_is_of_the_worst_angle_or_the_radius_ratio(void**)
{
    Random random(7);
    const auto point = [&] { return Vec3(random.unit(), random.unit(), random.unit()); };
    int obtuse_decides = 0, ratio_decides = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 a = point(), b = point(), c = point(), d = point();
        if (!(orient(a, b, c, d) > 1e-4))
            continue;
        double expected = 1;
        for (const double angle : dihedral_angles(a, b, c, d))
            expected = std::min(expected, std::sin(angle * M_PI / 180) * (angle > 90 ? kObtuseWeight : 1));
        obtuse_decides += expected < 0.999 * least_sine(a, b, c, d);
        assert_true(std::abs(angle_quality(a, b, c, d) - expected) < 1e-9);
        assert_true(std::abs(angle_quality(b, a, c, d) + expected) < 1e-9);
        // The radius ratio that it has is too large by 42 % at most, where two faces have no area.
        const double by_ratio = kRatioWeight / radius_ratio(a, b, c, d), quality = shape_quality(a, b, c, d);
        assert_true(quality <= expected + 1e-9 && quality <= by_ratio * (1 + 1e-9));
        assert_true(quality >= std::min(expected, by_ratio / 1.4143) - 1e-9);
        ratio_decides += quality < 0.999 * expected;
    }
    assert_true(obtuse_decides > 100 && ratio_decides > 100);
    assert_true(greatest_ratio(25) <= 8 && greatest_ratio(25) > 7.999);
    // 155 degrees are as bad as 20.
    assert_true(kObtuseWeight * std::sin(155 * M_PI / 180) <= std::sin(20 * M_PI / 180));
    assert_true(kObtuseWeight * std::sin(154.9 * M_PI / 180) > std::sin(20 * M_PI / 180));
}

// Against differences, where one angle or the radius ratio decides.
static void gradients_are_those_of_the_quality(void**)
{
    Random random(8);
    const auto point = [&] { return Vec3(random.unit(), random.unit(), random.unit()); };
    Array<double> quality;
    Array<Vec3> gradient;
    int compared = 0, ratio_decides = 0;
    for (int i = 0; i < 3000; ++i) {
        const Array<Vec3> points{point(), point(), point(), point()};
        if (!(orient(points[0], points[1], points[2], points[3]) > 0.02))
            continue;
        for (int32_t v = 0; v < 4; ++v) {
            const LocalMesh mesh(points, {{0, 1, 2, 3}}, {}, Run{});
            TetStar star;
            star.load(mesh, v);
            const Vec3 x = points[v];
            star.gradients_at(x, quality, gradient);
            assert_int_equal(quality.size(), 1);
            assert_true(quality[0] == star.worst_at(x, -1));
            constexpr double kStep = 1e-6;
            Vec3 central, forward;
            for (int axis = 0; axis < 3; ++axis) {
                const Vec3 step = kStep * Vec3::Unit(axis);
                const double ahead = star.worst_at(x + step, -1), behind = star.worst_at(x - step, -1);
                central[axis] = (ahead - behind) / (2 * kStep);
                forward[axis] = (ahead - quality[0]) / kStep;
            }
            if ((central - forward).norm() > 1e-3 * (1 + central.norm()))
                continue;  // two decide
            assert_true((gradient[0] - central).norm() < 1e-5 * (1 + central.norm()));
            ++compared;
            ratio_decides += quality[0] < 0.999 * angle_quality(points[0], points[1], points[2], points[3]);
        }
    }
    assert_true(compared > 1000 && ratio_decides > 50);
}

static void qualities_found_together_are_those_found_one_by_one(void**)
{
    Run two_threads;
    two_threads.threads = 2;
    for (const TetMesh& plain : meshes()) {
        const LocalMesh together = local(plain), alone = local(plain);
        together.find_qualities(two_threads);
        for (int32_t t = 0; t < alone.slot_count(); ++t)
            assert_true(together.quality(t) == alone.quality(t));
    }
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(neighbours_and_frozen_axes_are_those_of_the_plain_mesh),
        cmocka_unit_test(a_tetrahedron_at_two_points_has_both),
        cmocka_unit_test(a_ring_tells_where_it_is_not_all),
        cmocka_unit_test(a_ring_goes_round_its_edge),
        cmocka_unit_test(an_operation_can_be_taken_back),
        cmocka_unit_test(what_is_known_of_quality_follows_the_moves),
        cmocka_unit_test(bad_corners_are_refused),
        cmocka_unit_test(gradients_are_those_of_the_quality),
        cmocka_unit_test(qualities_found_together_are_those_found_one_by_one),
        cmocka_unit_test(quality_is_of_the_worst_angle_or_the_radius_ratio),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
