// Points of which many lie on one sphere, in one plane or at one place: the mesh is Delaunay, unique and without flat
// tetrahedra.
#include "background/point_sets.hpp"
#include "base/ordinal.hpp"
#include "engines.hpp"
#include "support/cmocka.hpp"

#include <string>

using namespace cleft;
using namespace cleft_test;

namespace
{

void check(Array<Vec3> points, double longest)
{
    for (Vec3& p : points)
        p /= longest;
    const Array<Tet> whole = in_bricks(points, points.count());
    assert_true(is_delaunay(points, whole));
    assert_true(in_bricks(points, 40) == whole);
}

std::string refusal(const Array<Vec3>& points)
{
    try {
        delaunay(points, DelaunayEngine::cleft, Run{});
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

static void lattices_are_meshed(void**)
{
    check(cubic_lattice(6), 6);
    check(bcc_lattice(5, 0, 0), 5);
    Array<Vec3> tilted = cubic_lattice(5);
    for (Vec3& p : tilted)  // whole numbers, so the planes stay exact
        p = Vec3(2 * p[0] - p[1] + p[2], p[0] + 3 * p[1], 5 * p[2] - p[0]);
    check(tilted, 32);
}

// Whole coordinates with one sum of squares.
static void spheres_are_meshed(void**)
{
    Array<Vec3> points;
    for (int x = -9; x <= 9; ++x)
        for (int y = -9; y <= 9; ++y)
            for (int z = -9; z <= 9; ++z)
                if (x * x + y * y + z * z == 81)
                    points.emplace_back(x, y, z);
    assert_true(points.size() > 100);
    check(points, 9);
    points.emplace_back(0, 0, 0);
    check(points, 9);
}

static void walls_and_edges_are_meshed(void**)
{
    Random random(1);
    Array<Vec3> points;
    for (int i = 0; i < 600; ++i) {
        Vec3 p(static_cast<double>(random.below(9)), static_cast<double>(random.below(9)),
               static_cast<double>(random.below(9)));
        p[i % 3] = random.below(2) != 0 ? 8 : 0;
        if (std::find(points.begin(), points.end(), p) == points.end())
            points.push_back(p);
    }
    check(points, 8);
}

static void few_points_are_meshed(void**)
{
    check({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}, 1);
    check({Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 0), Vec3(1, 1, 1)}, 1);
}

static void flat_sets_with_one_point_off_are_meshed(void**)
{
    Array<Vec3> points;
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 12; ++j)
            points.emplace_back(i, j, 0);
    points.emplace_back(5, 6, 1e-12);
    check(points, 12);
    points.back() = Vec3(5, 6, 1e-300);
    check(points, 12);
    points.back() = Vec3(-3, 40, 12);
    check(points, 40);
}

static void very_small_clusters_are_meshed(void**)
{
    Random random(2);
    Array<Vec3> points = random_points(40, Vec3(1, 1, 1), 3);
    for (const double size : {1e-12, 1e-30, 1e-100, 1e-200})
        for (int i = 0; i < 20; ++i)
            points.push_back(random_in_box(random, Vec3(size, size, size)) +
                             (i % 2 ? Vec3(0, 0, 0) : Vec3(size, 0, 0)));
    check(points, 1);
}

static void points_at_one_place_are_named(void**)
{
    for (const int count : {50, 3000}) {
        Array<Vec3> points = random_points(count, Vec3(1, 1, 1), 6);
        for (int i = count - 1; i > count - 20; i -= 3) {
            Array<Vec3> bad = points;
            bad[i] = bad[count - i];
            assert_string_equal(refusal(bad).c_str(), ("the " + ordinal(i) + " point lies on another point").c_str());
            bool is_seen = false;
            try {
                in_bricks(bad, 10);
            } catch (const TwoAtOnePlace&) {
                is_seen = true;
            }
            assert_true(is_seen);
        }
    }
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(lattices_are_meshed),
        cmocka_unit_test(spheres_are_meshed),
        cmocka_unit_test(walls_and_edges_are_meshed),
        cmocka_unit_test(few_points_are_meshed),
        cmocka_unit_test(flat_sets_with_one_point_off_are_meshed),
        cmocka_unit_test(very_small_clusters_are_meshed),
        cmocka_unit_test(points_at_one_place_are_named),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
