// The sign of an orientation against rational numbers, where rounding would decide it wrongly.
#include "mesh/predicates.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include <cfloat>

#include "mesh/quality.hpp"
#include "support/cmocka.hpp"
#include "support/random.hpp"

using namespace cleft;
using boost::multiprecision::cpp_rational;
using cleft_test::Random;

namespace
{

using Points = std::array<Vec3, 4>;

int orient_sign(const Points& p) { return cleft::orient_sign(p[0], p[1], p[2], p[3]); }

// The determinant in rational numbers, by other minors than those of the library.
int rational_sign(const Points& p)
{
    cpp_rational m[3][3];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            m[i][j] = cpp_rational(p[static_cast<size_t>(i) + 1][j]) - cpp_rational(p[0][j]);
    const cpp_rational det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                             m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                             m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    return det.sign();
}

Vec3 random_point(Random& random)
{
    const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
    return Vec3(x, y, z);
}

// Three points and a fourth in their plane up to rounding.
Points nearly_coplanar(Random& random, double scale, const Vec3& shift)
{
    Points p = {random_point(random), random_point(random), random_point(random), Vec3()};
    const double s = random.between(-1, 2), t = random.between(-1, 2);
    p[3] = p[0] + s * (p[1] - p[0]) + t * (p[2] - p[0]);
    for (Vec3& x : p)
        x = x * scale + shift;
    return p;
}

void simple_orientations(void**)
{
    const Vec3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    assert_int_equal(orient_sign({o, x, y, z}), 1);
    assert_int_equal(orient_sign({o, y, x, z}), -1);
    assert_int_equal(orient_sign({o, x, y, Vec3(0.3, 0.4, 0)}), 0);
    assert_int_equal(orient_sign({o, o, o, o}), 0);
    assert_int_equal(orient_sign({x, x, y, z}), 0);
}

void nearly_coplanar_points_agree_with_rationals(void**)
{
    Random random(1);
    int met[3] = {0, 0, 0}, wrong_in_doubles = 0;
    for (int round = 0; round < 3000; ++round) {
        const Points p = nearly_coplanar(random, 1, random_point(random) * (round % 3 * 1000));
        const int expected = rational_sign(p);
        assert_int_equal(orient_sign(p), expected);
        const double det = orient(p[0], p[1], p[2], p[3]);
        wrong_in_doubles += (det > 0) - (det < 0) != expected;
        ++met[expected + 1];
    }
    // The points are a test only if plain arithmetic fails on them.
    assert_true(wrong_in_doubles > 100);
    assert_true(met[0] > 100 && met[2] > 100);
}

// The case of Kettner et al., "Classroom examples of robustness problems": neighbours in a grid of one ulp.
void a_grid_of_neighbouring_numbers_agrees_with_rationals(void**)
{
    for (int i = 0; i < 24; ++i)
        for (int j = 0; j < 24; ++j) {
            const Points p = {Vec3(0.5 + i * DBL_EPSILON, 0.5 + j * DBL_EPSILON, 0.5), Vec3(12, 12, 12),
                              Vec3(24, 24, 24), Vec3(0.5, 0.5, 7)};
            assert_int_equal(orient_sign(p), rational_sign(p));
        }
}

void any_finite_size_is_exact(void**)
{
    Random random(2);
    for (const double scale : {DBL_TRUE_MIN * 64, DBL_MIN, 1e-200, 1e-110, 1e-6, 1e6, 1e95, 1e160, DBL_MAX / 8})
        for (int round = 0; round < 40; ++round) {
            const Points p = nearly_coplanar(random, scale, Vec3(0, 0, 0));
            assert_int_equal(orient_sign(p), rational_sign(p));
        }
}

void sizes_may_differ_within_one_tetrahedron(void**)
{
    Random random(4);
    for (int round = 0; round < 500; ++round) {
        Points p;
        for (Vec3& x : p)
            for (double& c : x)
                c = std::ldexp(random.between(-1, 1), static_cast<int>(random.below(2090)) - 1066);
        assert_int_equal(orient_sign(p), rational_sign(p));
    }
    const double m = DBL_MAX, e = DBL_TRUE_MIN;
    assert_int_equal(orient_sign({Vec3(-m, -m, -m), Vec3(m, -m, -m), Vec3(-m, m, -m), Vec3(-m, -m, m)}), 1);
    assert_int_equal(orient_sign({Vec3(0, 0, 0), Vec3(m, 0, 0), Vec3(0, m, 0), Vec3(m, m, e)}), 1);
    assert_int_equal(orient_sign({Vec3(0, 0, 0), Vec3(e, 0, 0), Vec3(0, e, 0), Vec3(e, e, -e)}), -1);
}

// -det of the rows (x - e, |x - e|^2), by expansion along the last column.
int rational_sphere_sign(const Points& p, const Vec3& e)
{
    std::array<std::array<cpp_rational, 4>, 4> m;
    for (size_t i = 0; i < 4; ++i)
        for (size_t j = 0; j < 3; ++j) {
            const auto axis = static_cast<Eigen::Index>(j);
            m[i][j] = cpp_rational(p[i][axis]) - cpp_rational(e[axis]);
            m[i][3] += m[i][j] * m[i][j];
        }
    cpp_rational det = 0;
    for (size_t i = 0; i < 4; ++i) {
        const auto &a = m[i == 0 ? 1 : 0], &b = m[i <= 1 ? 2 : 1], &c = m[i <= 2 ? 3 : 2];
        const cpp_rational minor = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                                   a[2] * (b[0] * c[1] - b[1] * c[0]);
        det += (i % 2 ? 1 : -1) * m[i][3] * minor;
    }
    return -det.sign();
}

// The corners of a positive tetrahedron on one sphere up to rounding, and a fifth point on it.
void nearly_cospherical_points_agree_with_rationals(void**)
{
    Random random(5);
    int met[3] = {0, 0, 0};
    for (const double scale : {DBL_MIN, 1e-200, 1e-40, 1.0, 1e50, 1e100, 1e153})
        for (int round = 0; round < 300; ++round) {
            const Vec3 shift = random_point(random) * (round % 3 * 100);
            std::array<Vec3, 5> q;
            for (Vec3& x : q)
                x = (random_point(random).normalized() + shift) * scale;
            if (cleft::orient_sign(q[0], q[1], q[2], q[3]) < 0)
                std::swap(q[0], q[1]);
            const int expected = rational_sphere_sign({q[0], q[1], q[2], q[3]}, q[4]);
            assert_int_equal(in_sphere_sign(q[0], q[1], q[2], q[3], q[4]), expected);
            ++met[expected + 1];
            assert_int_equal(in_sphere_sign(q[0], q[1], q[2], q[3], 0.25 * (q[0] + q[1] + q[2] + q[3])), 1);
            assert_int_equal(in_sphere_sign(q[0], q[1], q[2], q[3], q[round % 4 > 0 ? 1 : 3]), 0);
        }
    assert_true(met[0] > 100 && met[2] > 100);
}

void an_odd_permutation_turns_the_sign(void**)
{
    Random random(3);
    for (int round = 0; round < 200; ++round) {
        const Points p = nearly_coplanar(random, 1, Vec3(0, 0, 0));
        const int sign = orient_sign(p);
        assert_int_equal(orient_sign({p[1], p[0], p[2], p[3]}), -sign);
        assert_int_equal(orient_sign({p[0], p[3], p[2], p[1]}), -sign);
        assert_int_equal(orient_sign({p[1], p[2], p[0], p[3]}), sign);
        assert_int_equal(orient_sign({p[3], p[2], p[1], p[0]}), sign);
    }
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(simple_orientations),
        cmocka_unit_test(nearly_coplanar_points_agree_with_rationals),
        cmocka_unit_test(a_grid_of_neighbouring_numbers_agrees_with_rationals),
        cmocka_unit_test(any_finite_size_is_exact),
        cmocka_unit_test(sizes_may_differ_within_one_tetrahedron),
        cmocka_unit_test(nearly_cospherical_points_agree_with_rationals),
        cmocka_unit_test(an_odd_permutation_turns_the_sign),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
