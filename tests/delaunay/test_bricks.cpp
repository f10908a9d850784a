// The tetrahedra depend neither on the bricks nor on the threads, and a cancel is seen at once.
#include "engines.hpp"
#include "random_sets.hpp"
#include "support/cmocka.hpp"

#include <atomic>

using namespace cleft;
using namespace cleft_test;

static void small_bricks_give_what_one_gives(void**)
{
    Random random(1);
    for (int i = 0; i < 100; ++i) {
        const Array<Vec3> points = random_set(i, 100 + static_cast<int>(random.below(900)), random.bits());
        const Array<Tet> whole = in_bricks(points, points.count());
        for (const int64_t size : {i < 5 ? 2 : 20, 50, 200})
            assert_true(in_bricks(points, size) == whole);
    }
}

static void graded_bricks_give_what_one_gives(void**)
{
    for (const double gradation : {0.02, 0.2, 0.5}) {
        const Array<Vec3> points = PoissonPoints(0.02, gradation, 7).points;
        const Array<Tet> whole = in_bricks(points, points.count());
        assert_true(in_bricks(points, 100) == whole);
        assert_true(in_bricks(points, 2000) == whole);
    }
}

// Spheres that reach through the empty space.
static void bricks_far_apart_find_each_other(void**)
{
    Random random(3);
    Array<Vec3> points;
    for (int i = 0; i < 3000; ++i) {
        const Vec3 p = random_in_box(random, Vec3(0.01, 0.01, 0.01));
        points.push_back(p + 0.9 * Vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1));
    }
    assert_true(in_bricks(points, 100) == in_bricks(points, points.count()));
    for (size_t i = 0; i < points.size(); ++i) {
        const Vec3 p = random_in_box(random, Vec3(1, 1, 1)) - Vec3(0.5, 0.5, 0.5);
        points[i] = i % 2 ? Vec3(p.normalized() * (0.9 + 1e-6 * p[0])) : Vec3(0.1 * p);
    }
    assert_true(in_bricks(points, 100) == in_bricks(points, points.count()));
}

static void threads_do_not_matter(void**)
{
    const Array<Vec3> points = PoissonPoints(0.03, 0.1, 4).points;
    const Array<Tet> alone = in_bricks(points, 500);
    for (const int threads : {2, 3, 8})
        assert_true(in_bricks(points, 500, threads) == alone);
}

static void a_cancel_is_seen_soon(void**)
{
    const Array<Vec3> points = random_points(50000, Vec3(1, 1, 1), 9);
    std::atomic<int> looks{0};
    Run run;
    run.repeat_progress = [&] { return ++looks == 20; };
    cleft_status status = CLEFT_OK;
    try {
        delaunay(points, DelaunayEngine::cleft, run);
    } catch (const Error& error) {
        status = error.status();
    }
    assert_int_equal(status, CLEFT_ERROR_CANCELLED);
    assert_int_equal(looks, 20);
}

// The longest wait for a cancel is the longest time between two looks: some hundred insertions.
static void looks_for_a_cancel_are_many(void**)
{
    const Array<Vec3> points = random_points(50000, Vec3(1, 1, 1), 9);
    std::atomic<int> looks{0};
    Run run;
    run.repeat_progress = [&] {
        ++looks;
        return false;
    };
    delaunay(points, DelaunayEngine::cleft, run);
    assert_true(looks > 50000 / 256);
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(small_bricks_give_what_one_gives),
        cmocka_unit_test(graded_bricks_give_what_one_gives),
        cmocka_unit_test(bricks_far_apart_find_each_other),
        cmocka_unit_test(threads_do_not_matter),
        cmocka_unit_test(a_cancel_is_seen_soon),
        cmocka_unit_test(looks_for_a_cancel_are_many),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
