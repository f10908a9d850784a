// Repair: slivers go, the box and the hull of any other mesh stay exactly.
#include "background/repair.hpp"
#include "delaunay/delaunay.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"
#include "point_sets.hpp"
#include "support/cmocka.hpp"

#include <cmath>

using namespace cleft;
using namespace cleft_test;

namespace
{

TetMesh delaunay_mesh(Array<Vec3> points)
{
    TetMesh mesh;
    mesh.tets = delaunay(points, DelaunayEngine::cleft, Run{});
    mesh.points = std::move(points);
    return mesh;
}

struct Shape {
    double volume = 0, min_angle = 180;
    bool positive = true;
};

Shape shape_of(const TetMesh& mesh)
{
    Shape s;
    for (const Tet& t : mesh.tets) {
        const auto p = [&](size_t i) -> const Vec3& { return mesh.points[t[i]]; };
        s.volume += orient(p(0), p(1), p(2), p(3)) / 6;
        s.positive = s.positive && orient_sign(p(0), p(1), p(2), p(3)) > 0;
        for (const double angle : dihedral_angles(p(0), p(1), p(2), p(3)))
            s.min_angle = std::min(s.min_angle, angle);
    }
    return s;
}

double hull_area_off_box(const TetMesh& mesh, const Vec3& extent)
{
    const auto neighbours = tet_neighbours(mesh.tets, static_cast<int64_t>(mesh.points.size()));
    double area = 0;
    for (size_t t = 0; t < mesh.tets.size(); ++t)
        for (size_t i = 0; i < 4; ++i) {
            if (neighbours[t][i] >= 0)
                continue;
            const auto p = [&](int k) -> const Vec3& { return mesh.points[mesh.tets[t][kFaceCorners[i][k]]]; };
            bool on_wall = false;
            for (int a = 0; a < 3; ++a)
                for (const double wall : {0.0, extent[a]})
                    on_wall = on_wall || (p(0)[a] == wall && p(1)[a] == wall && p(2)[a] == wall);
            if (!on_wall)
                area += (p(1) - p(0)).cross(p(2) - p(0)).norm() / 2;
        }
    return area;
}

// Repairs a mesh of the box [0, extent] and says whether it is still one, with the same points on the same walls.
bool repair_keeps_the_box(TetMesh& mesh, const Vec3& extent, const RepairOptions& options = {})
{
    const Array<Vec3> before = mesh.points;
    repair(mesh, options, Run{});
    const Shape shape = shape_of(mesh);
    bool walls_kept = mesh.points.size() == before.size();
    for (size_t v = 0; v < before.size() && walls_kept; ++v)
        for (int a = 0; a < 3; ++a)
            if (before[v][a] == 0 || before[v][a] == extent[a])
                walls_kept = walls_kept && mesh.points[v][a] == before[v][a];
    return walls_kept && shape.positive && std::abs(shape.volume / extent.prod() - 1) < 1e-12 &&
           hull_area_off_box(mesh, extent) == 0;
}

}  // namespace

static void jittered_lattices_reach_28_degrees(void**)
{
    const int n = 16;
    for (const double jitter : {1e-9, 0.1, 0.2}) {
        TetMesh mesh = delaunay_mesh(bcc_lattice(n, jitter, 1));
        assert_true(repair_keeps_the_box(mesh, Vec3(n, n, n)));
        assert_true(shape_of(mesh).min_angle > 28);
    }
}

static void scattered_points_reach_25_degrees(void**)
{
    for (const double gradation : {0.0, 0.1}) {
        TetMesh mesh = delaunay_mesh(PoissonPoints(0.05, gradation, 2).points);
        assert_true(repair_keeps_the_box(mesh, Vec3(1, 1, 1)));
        assert_true(shape_of(mesh).min_angle > 25);
    }
}

static void random_points_get_better(void**)
{
    TetMesh mesh = delaunay_mesh(random_points(2000, Vec3(1, 2, 0.5), 3));
    const double before = shape_of(mesh).min_angle;
    assert_true(repair_keeps_the_box(mesh, Vec3(1, 2, 0.5)));
    assert_true(shape_of(mesh).min_angle > before);
}

static void flips_alone_never_make_the_worst_worse(void**)
{
    RepairOptions options;
    options.sweeps = 0;
    for (uint64_t seed = 0; seed < 20; ++seed) {
        TetMesh mesh = delaunay_mesh(random_points(60, Vec3(1, 1, 1), seed));
        const double before = shape_of(mesh).min_angle;
        assert_true(repair_keeps_the_box(mesh, Vec3(1, 1, 1), options));
        assert_true(shape_of(mesh).min_angle >= before);
    }
}

static void any_scale_gives_the_same_mesh(void**)
{
    TetMesh mesh = delaunay_mesh(bcc_lattice(6, 0.2, 4));
    const TetMesh input = mesh;
    repair(mesh, {}, Run{});
    for (const int exponent : {-40, 40}) {
        TetMesh scaled = input;
        for (Vec3& p : scaled.points)
            p *= std::ldexp(1.0, exponent);
        repair(scaled, {}, Run{});
        assert_true(scaled.tets == mesh.tets);
        for (size_t v = 0; v < mesh.points.size(); ++v)
            assert_true(scaled.points[v] * std::ldexp(1.0, -exponent) == mesh.points[v]);
    }
}

static void a_round_hull_keeps_its_points(void**)
{
    Array<Vec3> points;
    for (const Vec3& p : PoissonPoints(0.08, 0, 5).points)
        if ((p - Vec3(0.5, 0.5, 0.5)).norm() < 0.5)
            points.push_back(p);
    TetMesh mesh = delaunay_mesh(points);
    const auto neighbours = tet_neighbours(mesh.tets, static_cast<int64_t>(points.size()));
    const auto frozen = frozen_axes(points, mesh.tets, neighbours);
    const double volume = shape_of(mesh).volume;
    repair(mesh, {}, Run{});
    size_t hull_points = 0;
    for (size_t v = 0; v < points.size(); ++v)
        if (frozen[v] == 7) {
            ++hull_points;
            assert_true(mesh.points[v] == points[v]);
        }
    assert_true(hull_points > 100);
    assert_true(shape_of(mesh).positive);
    assert_true(std::abs(shape_of(mesh).volume / volume - 1) < 1e-12);
}

static void one_tetrahedron_stays(void**)
{
    TetMesh mesh{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.3, 0.3, 0.01)}, {{0, 1, 2, 3}}};
    const TetMesh input = mesh;
    repair(mesh, {}, Run{});
    assert_true(mesh.tets == input.tets);
    assert_true(mesh.points == input.points);
}

static void notes_tell_before_and_after(void**)
{
    TetMesh mesh = delaunay_mesh(bcc_lattice(10, 0.2, 6));
    const Shape before = shape_of(mesh);
    Metrics metrics;
    Run run;
    run.metrics = &metrics;
    repair(mesh, {}, run);
    assert_true(std::abs(metrics.get("background.repair.min_angle_before") - before.min_angle) < 1e-9);
    assert_true(std::abs(metrics.get("background.repair.min_angle_after") - shape_of(mesh).min_angle) < 1e-9);
    assert_true(metrics.get("background.repair.below_10_before") > 0);
    assert_true(metrics.get("background.repair.below_25_after", -1) == 0);
    assert_true(metrics.get("background.repair.tets_after") == static_cast<double>(mesh.tets.size()));
}

static void the_same_bytes_every_time(void**)
{
    const TetMesh input = delaunay_mesh(bcc_lattice(8, 0.2, 7));
    TetMesh first = input, second = input;
    repair(first, {}, Run{});
    Run two_threads;
    two_threads.threads = 2;
    repair(second, {}, two_threads);
    assert_true(first.tets == second.tets);
    assert_true(first.points == second.points);
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(jittered_lattices_reach_28_degrees),
        cmocka_unit_test(scattered_points_reach_25_degrees),
        cmocka_unit_test(random_points_get_better),
        cmocka_unit_test(flips_alone_never_make_the_worst_worse),
        cmocka_unit_test(any_scale_gives_the_same_mesh),
        cmocka_unit_test(a_round_hull_keeps_its_points),
        cmocka_unit_test(one_tetrahedron_stays),
        cmocka_unit_test(notes_tell_before_and_after),
        cmocka_unit_test(the_same_bytes_every_time),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
