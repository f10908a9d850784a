// Measures of shape against known tetrahedra and other formulas, and their summary against a count of all.
#include "mesh/quality.hpp"

#include "mesh/adjacency.hpp"
#include "support/bcc.hpp"
#include "support/cmocka.hpp"
#include "support/near.hpp"

#include <cmath>
#include <set>

using namespace cleft;
using cleft_test::jittered_bcc;
using cleft_test::near;
using cleft_test::Random;

namespace
{

using Points = FixedArray<Vec3, 4>;
constexpr double kPi = 3.14159265358979323846;

const Points kRegular = {Vec3(1, 1, 1), Vec3(-1, 1, -1), Vec3(1, -1, -1), Vec3(-1, -1, 1)};
const Points kCorner = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};

double least_sine(const Points& x) { return cleft::least_sine(x[0], x[1], x[2], x[3]); }
FixedArray<double, 6> dihedral_angles(const Points& x) { return cleft::dihedral_angles(x[0], x[1], x[2], x[3]); }
double radius_ratio(const Points& x) { return cleft::radius_ratio(x[0], x[1], x[2], x[3]); }

Points random_tet(Random& random)
{
    Points x;
    do {
        for (Vec3& p : x)
            for (double& c : p)
                c = random.between(-1, 1);
    } while (orient(x[0], x[1], x[2], x[3]) < 1e-3);
    return x;
}

Points corners(const TetMesh& mesh, size_t t)
{
    Points x;
    for (size_t i = 0; i < 4; ++i)
        x[i] = mesh.points[mesh.tets[t][i]];
    return x;
}

// The angle at an edge between the parts of two other edges across it.
double angle_across(const Points& x, size_t edge)
{
    const Vec3& a = x[kEdgeCorners[edge][0]];
    const Vec3 along = (x[kEdgeCorners[edge][1]] - a).normalized();
    Vec3 v = x[kEdgeOpposite[edge][0]] - a;
    Vec3 w = x[kEdgeOpposite[edge][1]] - a;
    v -= v.dot(along) * along;
    w -= w.dot(along) * along;
    return 180 / kPi * std::acos(v.dot(w) / (v.norm() * w.norm()));
}

// The circumcentre solves a linear system; the insphere touches four faces.
double radius_ratio_by_centres(const Points& x)
{
    Mat3 rows;
    Vec3 right;
    for (int i = 0; i < 3; ++i) {
        const Vec3 edge = x[static_cast<size_t>(i) + 1] - x[0];
        rows.row(i) = 2 * edge.transpose();
        right[i] = edge.squaredNorm();
    }
    const double circumradius = Vec3(rows.inverse() * right).norm();
    double area = 0;
    for (const auto& f : kFaceCorners) {
        const Vec3& a = x[f[0]];
        area += (x[f[1]] - a).cross(x[f[2]] - a).norm() / 2;
    }
    return circumradius / (3 * (3 * orient(x[0], x[1], x[2], x[3]) / 6 / area));
}

void known_tetrahedra(void**)
{
    for (const double angle : dihedral_angles(kRegular))
        assert_true(near(angle, 180 / kPi * std::acos(1.0 / 3), 1e-12));
    assert_true(near(least_sine(kRegular), std::sqrt(8.0) / 3, 1e-14));
    assert_true(near(radius_ratio(kRegular), 1, 1e-14));
    const FixedArray<double, 6> angles = dihedral_angles(kCorner);
    for (size_t e = 0; e < 3; ++e)
        assert_true(near(angles[e], 90, 1e-12));
    for (size_t e = 3; e < 6; ++e)
        assert_true(near(angles[e], 180 / kPi * std::atan(std::sqrt(2.0)), 1e-12));
}

void measures_agree_with_other_formulas(void**)
{
    Random random(1);
    for (int round = 0; round < 500; ++round) {
        const Points x = random_tet(random);
        const FixedArray<double, 6> angles = dihedral_angles(x);
        double least = 1;
        for (size_t e = 0; e < 6; ++e) {
            assert_true(near(angles[e], angle_across(x, e), 1e-5));
            least = std::min(least, std::sin(angles[e] * kPi / 180));
        }
        assert_true(near(least_sine(x), least, 1e-12));
        assert_true(near(radius_ratio(x) / radius_ratio_by_centres(x), 1, 1e-9));
    }
}

void inverted_and_flat_tetrahedra_have_their_signs(void**)
{
    Random random(2);
    for (int round = 0; round < 100; ++round) {
        const Points x = random_tet(random);
        const Points turned = {x[1], x[0], x[2], x[3]};
        assert_true(near(least_sine(turned), -least_sine(x), 1e-12));
        assert_true(near(dihedral_angles(turned)[0], dihedral_angles(x)[0], 1e-9));
    }
    const Vec3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0);
    assert_true(least_sine({o, x, y, Vec3(0.25, 0.5, 0)}) == 0);
    assert_true(least_sine({o, x, y, o}) == 0);
    assert_true(least_sine({o, o, o, o}) == 0);
    assert_true(least_sine({o, x, 2 * x, y}) == 0);
}

void shape_does_not_depend_on_size(void**)
{
    Random random(3);
    const Points x = random_tet(random);
    for (const double scale : {1e-9, 1e-6, 1e6, 1e9}) {
        Points scaled = x;
        for (Vec3& p : scaled)
            p *= scale;
        assert_true(near(least_sine(scaled), least_sine(x), 1e-12));
        assert_true(near(radius_ratio(scaled) / radius_ratio(x), 1, 1e-12));
    }
}

// With ranks in between, as numpy.percentile has it.
double percentile_by_sorting(Array<double> values, double share)
{
    std::sort(values.begin(), values.end());
    const double rank = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<size_t>(rank);
    const size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (rank - static_cast<double>(below)) * (values[above] - values[below]);
}

void the_summary_is_that_of_all_tetrahedra(void**)
{
    const TetMesh mesh = jittered_bcc(Vec3(3, 2, 1), {9, 8, 11}, 0.13);
    Array<double> ratios, angles, edges, edge_ratios, volumes;
    int64_t below_20 = 0, below_15 = 0, above_165 = 0;
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        const Points x = corners(mesh, t);
        Array<double> lengths, own;
        for (size_t e = 0; e < 6; ++e) {
            own.push_back(angle_across(x, e));
            lengths.push_back((x[kEdgeCorners[e][0]] - x[kEdgeCorners[e][1]]).norm());
        }
        std::sort(own.begin(), own.end());
        std::sort(lengths.begin(), lengths.end());
        below_15 += own.front() < 15;
        below_20 += own.front() < 20;
        above_165 += own.back() > 165;
        edge_ratios.push_back(lengths.back() / lengths.front());
        angles.insert(angles.end(), own.begin(), own.end());
        edges.insert(edges.end(), lengths.begin(), lengths.end());
        ratios.push_back(radius_ratio_by_centres(x));
        volumes.push_back(orient(x[0], x[1], x[2], x[3]) / 6);
    }
    const Run run;
    const Quality q = measure_quality(mesh.points, mesh.tets, run);
    assert_int_equal(q.tets, mesh.tets.size());
    assert_true(q.tets > 8192 / 2);
    assert_true(near(q.min_dihedral, *std::min_element(angles.begin(), angles.end()), 1e-6));
    assert_true(near(q.max_dihedral, *std::max_element(angles.begin(), angles.end()), 1e-6));
    assert_int_equal(q.below_5, 0);
    assert_int_equal(q.below_15, below_15);
    assert_int_equal(q.below_20, below_20);
    assert_true(0 < below_15 && below_15 < below_20 && 0 < above_165);
    assert_int_equal(q.above_165, above_165);
    assert_true(near(q.radius_ratio_median, percentile_by_sorting(ratios, 0.5), 1e-9));
    assert_true(near(q.radius_ratio_95, percentile_by_sorting(ratios, 0.95), 1e-9));
    assert_true(near(q.radius_ratio_max, percentile_by_sorting(ratios, 1), 1e-9));
    assert_true(near(q.edge_ratio_max, *std::max_element(edge_ratios.begin(), edge_ratios.end()), 1e-12));
    assert_true(near(q.min_edge, *std::min_element(edges.begin(), edges.end()), 1e-12));
    assert_true(near(q.max_edge, *std::max_element(edges.begin(), edges.end()), 1e-12));
    double sum = 0;
    for (const double length : edges)
        sum += length;
    assert_true(near(q.mean_edge, sum / static_cast<double>(edges.size()), 1e-12));
    assert_true(near(q.min_volume, *std::min_element(volumes.begin(), volumes.end()), 1e-15));
    assert_true(near(q.total_volume, 6, 1e-12));
    FixedArray<int64_t, 36> histogram{};
    for (const double angle : angles)
        ++histogram[static_cast<int>(angle / 5)];
    assert_true(histogram == q.dihedral_histogram);
}

void bad_tetrahedra_are_counted(void**)
{
    const Array<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.05}, {1, 1, 0}};
    const Run run;
    Quality q = measure_quality(points, {{0, 1, 2, 3}, {0, 1, 2, 3}}, run);
    assert_int_equal(q.below_5, 2);
    q = measure_quality(points, {{0, 1, 4, 2}, {0, 1, 2, 3}}, run);  // one is flat
    assert_true(q.min_dihedral == 0 && q.max_dihedral == 180);
    assert_int_equal(q.above_165, 1);
    assert_int_equal(q.dihedral_histogram[35], 2);
    assert_true(std::isfinite(q.radius_ratio_max));
    q = measure_quality(points, {{0, 1, 1, 2}}, run);  // a point twice
    assert_true(q.min_dihedral == 0 && q.max_dihedral < 180);
    q = measure_quality(points, {{1, 0, 2, 3}}, run);
    assert_true(q.min_volume < 0 && q.total_volume < 0);
    q = measure_quality(points, {}, run);
    assert_true(q.tets == 0 && q.mean_edge == 0 && q.min_edge == 0);
}

void one_and_two_threads_give_the_same_bytes(void**)
{
    const TetMesh mesh = jittered_bcc(Vec3(3, 2, 1), {18, 12, 9});
    Run one, two;
    two.threads = 2;
    const Quality a = measure_quality(mesh.points, mesh.tets, one), b = measure_quality(mesh.points, mesh.tets, two);
    assert_true(a.mean_edge == b.mean_edge && a.total_volume == b.total_volume && a.min_volume == b.min_volume);
    assert_true(a.radius_ratio_median == b.radius_ratio_median && a.radius_ratio_95 == b.radius_ratio_95);
    assert_true(a.min_dihedral == b.min_dihedral && a.dihedral_histogram == b.dihedral_histogram);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(known_tetrahedra),
        cmocka_unit_test(measures_agree_with_other_formulas),
        cmocka_unit_test(inverted_and_flat_tetrahedra_have_their_signs),
        cmocka_unit_test(shape_does_not_depend_on_size),
        cmocka_unit_test(the_summary_is_that_of_all_tetrahedra),
        cmocka_unit_test(bad_tetrahedra_are_counted),
        cmocka_unit_test(one_and_two_threads_give_the_same_bytes),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
