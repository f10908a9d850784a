// Root searches for ties: in a bracket on an edge, and by Newton steps near a vertex.
#include "volume/tie.hpp"

#include <cmath>
#include <limits>

namespace cleft
{

namespace
{

// In a label map a material without an entry has no share.
double value_of(const Samples& samples, Material m)
{
    const int i = samples.find(m);
    return i < 0 ? 0.0 : samples.value[i];
}

Vec3 gradient_of(const Samples& samples, Material m)
{
    const int i = samples.find(m);
    return i < 0 ? Vec3(0, 0, 0) : samples.gradient[i];
}

// The equations f_i - f_0 = 0, i = 1 .. n, at a point; rows past n are zero.
struct TieEquations {
    int n;
    Vec3 residual = Vec3::Zero();
    Mat3 jacobian = Mat3::Zero();

    TieEquations(const Samples& samples, const Material* material, int count) : n(count - 1)
    {
        CLEFT_ASSERT(n >= 1 && n <= 3);
        const double f0 = value_of(samples, material[0]);
        const Vec3 g0 = gradient_of(samples, material[0]);
        for (int i = 0; i < n; ++i) {
            residual[i] = value_of(samples, material[i + 1]) - f0;
            jacobian.row(i) = (gradient_of(samples, material[i + 1]) - g0).transpose();
        }
    }
};

// Solves the leading n x n part of m y = r; false if it is singular to working accuracy.
bool solve_leading(Mat3 m, const Vec3& r, int n, Vec3& y)
{
    double scale = 1;
    // Rows and columns past n become those of the identity, so that one 3 x 3 inverse serves all n.
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            if (i >= n || j >= n)
                m(i, j) = i == j;
        scale *= m.row(i).norm();
    }
    const double determinant = m.determinant();
    // Two ties whose gradients are nearly parallel, or a function that is flat. A step would lead far away, so the
    // caller keeps the place it has.
    if (!(std::abs(determinant) > 1e-6 * scale))
        return false;
    y = m.inverse() * r;
    return y.allFinite();
}

}  // namespace

double greatest_value(const Samples& samples, const MaterialSet& set)
{
    double greatest = -std::numeric_limits<double>::infinity();
    for (const Material m : set)
        greatest = std::max(greatest, value_of(samples, m));
    return greatest;
}

double find_cut(const Volume& volume, const EdgeTie& edge, Samples& scratch)
{
    // More steps place cuts more exactly, but not interfaces: what is between the cuts is far further off.
    constexpr int kSteps = 2;
    // Of the length of the edge: half of kLeastCut.
    constexpr double kTolerance = 0.01;
    double low = edge.difference_a, high = edge.difference_b;
    // An end on the wrong side has no root to bracket. This happens where a vertex lies on the tie, and in noise.
    if (!(low > 0))
        return kLeastCut;
    if (!(high < 0))
        return kGreatestCut;
    double t_low = 0, t_high = 1, t = low / (low - high);
    for (int step = 0; step < kSteps; ++step) {
        volume.sample(edge.a + t * (edge.b - edge.a), scratch);
        const double f = greatest_value(scratch, edge.A) - greatest_value(scratch, edge.B);
        if (f == 0)
            break;
        (f > 0 ? t_low : t_high) = t;
        (f > 0 ? low : high) = f;
        const double before = t;
        // False position keeps the bracket, so the cut stays on its edge whatever the function does.
        t = t_low + (t_high - t_low) * low / (low - high);
        if (std::abs(t - before) < kTolerance)
            break;
    }
    return std::clamp(t, kLeastCut, kGreatestCut);
}

namespace
{

Vec3 free_mask(unsigned frozen)
{
    Vec3 free(1, 1, 1);
    for (int axis = 0; axis < 3; ++axis)
        if (frozen >> axis & 1u)
            free[axis] = 0;
    return free;
}

// The point closest to `base` at which the equations, linearised at `at`, hold.
std::optional<Vec3> newton_step(const Volume& volume, const Vec3& base, const Vec3& at, const Material* material,
                                int count, const Vec3& free, Samples& scratch)
{
    volume.sample_gradient(at, scratch);
    const TieEquations tie(scratch, material, count);
    // Frozen axes drop out of the step, so that a point in a wall stays in it exactly.
    const Mat3 masked = tie.jacobian * free.asDiagonal();
    Vec3 multiplier;
    if (!solve_leading(masked * masked.transpose(), -tie.residual - tie.jacobian * (base - at), tie.n, multiplier))
        return std::nullopt;
    return base + masked.transpose() * multiplier;
}

bool has_tie(const MaterialSet& set, const Vec3& free)
{
    return set.size() >= 2 && set.size() <= 4 && set.size() - 1 <= free.sum();
}

}  // namespace

std::optional<Vec3> step_to_tie(const Volume& volume, const Vec3& x, const MaterialSet& set, unsigned frozen,
                                Samples& scratch)
{
    const Vec3 free = free_mask(frozen);
    if (!has_tie(set, free))
        return std::nullopt;
    Material material[4];
    std::copy(set.begin(), set.end(), material);
    return newton_step(volume, x, x, material, set.size(), free, scratch);
}

std::optional<Vec3> project_to_tie(const Volume& volume, const Vec3& x, const Vec3& start, const MaterialSet& set,
                                   unsigned frozen, double reach, Samples& scratch)
{
    // Near a tie each step squares the error. A search that needs more than five is in a place where functions hardly
    // differ.
    constexpr int kSteps = 5;
    constexpr double kTolerance = 0.02;
    const Vec3 free = free_mask(frozen);
    if (!has_tie(set, free))
        return std::nullopt;
    Material material[4];
    std::copy(set.begin(), set.end(), material);

    // The first step takes the point of the linearised tie closest to x; the next ones go from point to point.
    Vec3 base = x, at = start;
    for (int step = 0; step < kSteps; ++step) {
        const auto next = newton_step(volume, base, at, material, set.size(), free, scratch);
        if (!next || !((*next - x).norm() <= reach))
            return std::nullopt;
        const bool converged = (*next - at).norm() < kTolerance * reach;
        base = at = *next;
        if (converged)
            return at;
    }
    return std::nullopt;
}

std::optional<Vec3> nearest_on_tie(const Volume& volume, const Vec3& x, const Vec3& start, const MaterialSet& set,
                                   Samples& scratch)
{
    // The error falls by the distance divided by the radius of curvature in each step: six leave a hundredth of a voxel
    // of a distance of half the radius.
    constexpr int kSteps = 6;
    constexpr double kTolerance = 0.01, kReach = 2;  // of the spacing: least and greatest
    const Vec3 free(1, 1, 1);
    if (!has_tie(set, free))
        return std::nullopt;
    Material material[4];
    std::copy(set.begin(), set.end(), material);
    const Vec3& spacing = volume.grid().spacing;
    Vec3 at = start;
    for (int step = 0; step < kSteps; ++step) {
        const auto next = newton_step(volume, x, at, material, set.size(), free, scratch);
        if (!next || !((*next - start).norm() <= (x - start).norm() + kReach * spacing.maxCoeff()))
            return std::nullopt;
        const double moved = (*next - at).norm();
        at = *next;
        if (moved < kTolerance * spacing.minCoeff())
            return at;
    }
    return std::nullopt;
}

}  // namespace cleft
