// The door to the Delaunay engines: with each, valid, complete meshes of the convex hull, or a clear refusal.
#include "background/point_sets.hpp"
#include "engines.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"
#include "support/cmocka.hpp"

#include <limits>
#include <thread>

using namespace cleft;
using namespace cleft_test;

namespace
{

DelaunayEngine engine = DelaunayEngine::cleft;  // that all tests below call

struct Summary {
    double volume = 0;
    bool positive = true, all_used = true;
};

Summary summarize(const Array<Vec3>& points, const Array<Tet>& tets)
{
    Summary s;
    Array<char> used(points.size(), 0);
    for (const Tet& t : tets) {
        const auto p = [&](size_t i) { return points[t[i]]; };
        s.volume += orient(p(0), p(1), p(2), p(3)) / 6;
        s.positive = s.positive && orient_sign(p(0), p(1), p(2), p(3)) > 0;
        for (const int32_t v : t)
            used[v] = 1;
    }
    for (const char u : used)
        s.all_used = s.all_used && u;
    return s;
}

cleft_status refusal(const Array<Vec3>& points)
{
    try {
        delaunay(points, engine, Run{});
    } catch (const Error& error) {
        return error.status();
    }
    return CLEFT_OK;
}

// The mesh of a set that spans the box [0, extent] fills it with positive tetrahedra and uses every point.
bool fills_box(const Array<Vec3>& points, const Vec3& extent)
{
    const Summary s = summarize(points, delaunay(points, engine, Run{}));
    return s.positive && s.all_used && std::abs(s.volume / extent.prod() - 1) < 1e-12;
}

}  // namespace

static void random_points_fill_the_box(void**)
{
    const Vec3 extent(1, 2, 0.5);
    assert_true(fills_box(random_points(20000, extent, 1), extent));
}

static void scale_does_not_matter(void**)
{
    const Array<Vec3> points = random_points(2000, Vec3(1, 1, 1), 2);
    const Array<Tet> tets = delaunay(points, engine, Run{});
    for (const int exponent : {-600, -20, 20, 600}) {
        Array<Vec3> scaled = points;
        for (Vec3& p : scaled)
            p *= std::ldexp(1.0, exponent);
        assert_true(delaunay(scaled, engine, Run{}) == tets);
    }
}

static void thin_boxes_are_filled(void**)
{
    for (const double thickness : {1e-3, 1e-6, 1e-9}) {
        const Vec3 extent(1, 1, thickness);
        assert_true(fills_box(random_points(2000, extent, 3), extent));
    }
}

static void cospherical_lattices_are_exact(void**)
{
    const int n = 12;
    const Vec3 extent(n, n, n);
    assert_true(fills_box(cubic_lattice(n), extent));
    assert_true(fills_box(bcc_lattice(n, 0, 0), extent));
}

static void jittered_lattice_is_exact_on_the_hull(void**)
{
    const int n = 12;
    assert_true(fills_box(bcc_lattice(n, 1e-9, 4), Vec3(n, n, n)));
    assert_true(fills_box(bcc_lattice(n, 0.2, 5), Vec3(n, n, n)));
}

static void bad_points_are_refused(void**)
{
    Array<Vec3> points = random_points(50, Vec3(1, 1, 1), 6);
    assert_int_equal(refusal({points[0], points[1], points[2]}), CLEFT_ERROR_ARGUMENT);
    Array<Vec3> bad = points;
    bad[17].y() = std::numeric_limits<double>::quiet_NaN();
    assert_int_equal(refusal(bad), CLEFT_ERROR_NOT_FINITE);
    bad[17].y() = std::numeric_limits<double>::infinity();
    assert_int_equal(refusal(bad), CLEFT_ERROR_NOT_FINITE);
    bad = points;
    bad.push_back(points[33]);
    assert_int_equal(refusal(bad), CLEFT_ERROR_ARGUMENT);
}

static void flat_sets_are_refused(void**)
{
    Array<Vec3> points = random_points(50, Vec3(1, 1, 1), 7);
    for (Vec3& p : points)
        p.z() = 0.25;
    assert_int_equal(refusal(points), CLEFT_ERROR_ARGUMENT);
    for (Vec3& p : points)
        p.y() = p.x();
    assert_int_equal(refusal(points), CLEFT_ERROR_ARGUMENT);
    points.assign(50, Vec3(0, 0, 0));
    assert_int_equal(refusal(points), CLEFT_ERROR_ARGUMENT);
}

static void two_threads_at_once_agree_with_one(void**)
{
    const Array<Vec3> points = random_points(5000, Vec3(1, 1, 1), 8);
    const Array<Tet> alone = delaunay(points, engine, Run{});
    Array<Tet> results[2];
    std::thread other([&] { results[0] = delaunay(points, engine, Run{}); });
    results[1] = delaunay(points, engine, Run{});
    other.join();
    assert_true(results[0] == alone);
    assert_true(results[1] == alone);
}

static void a_cancel_is_seen(void**)
{
    std::atomic<bool> cancel{true};
    Run run;
    run.cancel = &cancel;
    cleft_status status = CLEFT_OK;
    try {
        delaunay(random_points(100, Vec3(1, 1, 1), 9), engine, run);
    } catch (const Error& error) {
        status = error.status();
    }
    assert_int_equal(status, CLEFT_ERROR_CANCELLED);
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(random_points_fill_the_box),
        cmocka_unit_test(scale_does_not_matter),
        cmocka_unit_test(thin_boxes_are_filled),
        cmocka_unit_test(cospherical_lattices_are_exact),
        cmocka_unit_test(jittered_lattice_is_exact_on_the_hull),
        cmocka_unit_test(bad_points_are_refused),
        cmocka_unit_test(flat_sets_are_refused),
        cmocka_unit_test(two_threads_at_once_agree_with_one),
        cmocka_unit_test(a_cancel_is_seen),
    };
    const int failed = cmocka_run_group_tests_name("cleft", tests, nullptr, nullptr);
    if (failed != 0 || !has_tetgen())
        return failed;
    engine = DelaunayEngine::tetgen;
    return cmocka_run_group_tests_name("tetgen", tests, nullptr, nullptr);
}
