// Two balls that touch: around the point the gap is thinner than any tetrahedron.
#include "support/cmocka.hpp"

#include "background/lattice.hpp"
#include "checking/validate.hpp"
#include "cleaving/cleave.hpp"
#include "fitting/relocate_gaps.hpp"
#include "fitting/relocate_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>

using namespace cleft;

namespace
{

constexpr int32_t kSide = 32;
const Grid kGrid{{kSide, kSide, kSide}, Vec3(1, 1, 1)};
const Vec3 kTouch(16.1, 15.8, 16.2);

struct Ball {
    Vec3 centre;
    double radius;

    double depth(const Vec3& x) const { return radius - (x - centre).norm(); }
};

using Balls = std::array<Ball, 2>;

Balls balls_along(const Vec3& direction, double first, double second)
{
    const Vec3 along = direction.normalized();
    return {{{kTouch - first * along, first}, {kTouch + second * along, second}}};
}

Volume volume_of(const Balls& balls)
{
    std::array<std::vector<double>, 3> fields;
    for (int v = 0; v < kSide * kSide * kSide; ++v) {
        const Vec3 x = kGrid.centre(v % kSide, v / kSide % kSide, v / kSide / kSide);
        const double a = balls[0].depth(x), b = balls[1].depth(x);
        fields[0].push_back(-std::max(a, b));
        fields[1].push_back(a);
        fields[2].push_back(b);
    }
    return Volume::from_indicators(std::vector<const double*>{fields[0].data(), fields[1].data(), fields[2].data()},
                                   kGrid, {}, Run());
}

// Of all points of interfaces, the greatest distance from the nearer ball.
double greatest_distance(const LocalMesh& mesh, const Balls& balls)
{
    double greatest = 0;
    for (int32_t v = 0; v < mesh.point_count(); ++v) {
        const auto star = mesh.star(v);
        const auto is_first = [&](int32_t t) { return mesh.material(t) == mesh.material(*star.begin()); };
        if (std::all_of(star.begin(), star.end(), is_first))
            continue;
        const Vec3& x = mesh.point(v);
        greatest = std::max(greatest, std::min(std::abs(balls[0].depth(x)), std::abs(balls[1].depth(x))));
    }
    return greatest;
}

double least_quality(const LocalMesh& mesh)
{
    double least = 1;
    for (int32_t t = 0; t < mesh.slot_count(); ++t)
        least = std::min(least, mesh.quality(t));
    return least;
}

LocalMesh mesh_of(const Volume& volume)
{
    return {cleave(volume, lattice_background(kGrid, 2, Run()), CleaveOptions(), Run()), Run()};
}

void points_in_the_gap_come_to_a_ball(void**)
{
    const double floor = std::sin(18 * M_PI / 180);
    for (const Balls& balls : {balls_along(Vec3(0.3, -0.2, 1), 9, 9), balls_along(Vec3(1, 0.7, -0.4), 10, 7),
                               balls_along(Vec3(1, 1, 0.1), 8, 6)}) {
        const Volume volume = volume_of(balls);
        LocalMesh mesh = mesh_of(volume);
        const double before = greatest_distance(mesh, balls), worst = least_quality(mesh);
        const LinePoints lines = relocate_lines(mesh, volume, floor, find_meetings(mesh, Run()), Run());
        assert_true(lines.without_tie.size() > 3);
        const auto in_gap = relocate_gaps(mesh, volume, floor, lines.without_tie, Run());
        assert_true(in_gap.size() >= lines.without_tie.size());
        for (const int32_t v : in_gap)
            assert_true((mesh.point(v) - kTouch).norm() < 5);
        assert_true(before > 0.14 && greatest_distance(mesh, balls) < 0.6 * before);
        assert_true(least_quality(mesh) >= std::min(worst, floor));
        assert_string_equal(validate(mesh.take(Run()), true, Run()).first_fault.c_str(), "");
    }
}

void without_such_points_nothing_moves(void**)
{
    const Volume volume = volume_of(balls_along(Vec3(1, 2, 3), 9, 8));
    LocalMesh mesh = mesh_of(volume);
    const std::vector<Vec3> before = mesh.points();
    assert_true(relocate_gaps(mesh, volume, 0.3, {}, Run()).empty());
    assert_true(mesh.points() == before);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(points_in_the_gap_come_to_a_ball),
        cmocka_unit_test(without_such_points_nothing_moves),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
