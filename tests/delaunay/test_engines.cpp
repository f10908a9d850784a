// Both engines give the same bytes for points in general position.
#include "engines.hpp"
#include "random_sets.hpp"
#include "support/cmocka.hpp"

using namespace cleft;
using namespace cleft_test;

namespace
{

Array<Tet> by(DelaunayEngine engine, const Array<Vec3>& points) { return delaunay(points, engine, Run{}); }

void assert_same(const Array<Vec3>& points)
{
    const Array<Tet> tets = by(DelaunayEngine::cleft, points);
    if (has_tetgen())
        assert_true(tets == by(DelaunayEngine::tetgen, points));
    else
        assert_true(is_delaunay(points, tets));
}

}  // namespace

static void a_thousand_small_sets_are_the_same(void**)
{
    Random random(1);
    for (int i = 0; i < 1000; ++i)
        assert_same(random_set(i, 5 + static_cast<int>(random.below(496)), random.bits()));
}

static void far_from_the_origin_they_are_the_same(void**)
{
    for (int i = 0; i < 50; ++i) {
        Array<Vec3> points = random_set(i % 2 * 4, 200, to_size(1000 + i));  // rounding would undo a jitter
        for (Vec3& p : points)
            p = 1e-3 * p + Vec3(1e3, -2e4, 3e5);
        assert_same(points);
    }
}

static void large_sets_are_the_same(void**)
{
    assert_same(PoissonPoints(0.018, 0.05, 2).points);
    assert_same(random_set(2, 120000, 3));
    assert_same(random_points(90000, Vec3(1, 0.1, 0.7), 4));
}

static void clusters_are_the_same(void**)
{
    Random random(5);
    assert_same(random_clusters(random, 100000));
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(a_thousand_small_sets_are_the_same),
        cmocka_unit_test(far_from_the_origin_they_are_the_same),
        cmocka_unit_test(large_sets_are_the_same),
        cmocka_unit_test(clusters_are_the_same),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
