#include "cleaving/tie.hpp"

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
    return i < 0 ? 0.0 : samples.value[static_cast<size_t>(i)];
}

Vec3 gradient_of(const Samples& samples, Material m)
{
    const int i = samples.find(m);
    return i < 0 ? Vec3(0, 0, 0) : samples.gradient[static_cast<size_t>(i)];
}

Material best_of(const Samples& samples, const MaterialSet& set)
{
    Material best = set[0];
    double greatest = value_of(samples, best);
    for (int i = 1; i < set.size(); ++i)
        if (const double value = value_of(samples, set[i]); value > greatest) {
            best = set[i];
            greatest = value;
        }
    return best;
}

// The equations f_i - f_0 = 0, i = 1 .. n, at a point; rows past n are zero.
struct TieEquations {
    int n;
    Vec3 residual = Vec3::Zero();
    Mat3 jacobian = Mat3::Zero();

    TieEquations(const Samples& samples, const Material* material, int count) : n(count - 1)
    {
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
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            if (i >= n || j >= n)
                m(i, j) = i == j;
        scale *= m.row(i).norm();
    }
    const double determinant = m.determinant();
    if (!(std::abs(determinant) > 1e-6 * scale))
        return false;
    y = m.inverse() * r;
    return y.allFinite();
}

Vec3 point_of(const SimplexTie& simplex, const Weights& w)
{
    Vec3 x = simplex.x[0];
    for (size_t i = 1; i < static_cast<size_t>(simplex.corners); ++i)
        x += w[i - 1] * (simplex.x[i] - simplex.x[0]);
    return x;
}

// Moves weights that are too small up to kLeastWeight, at the cost of the others.
Weights hold_inside(Weights w, int corners)
{
    const size_t n = static_cast<size_t>(corners) - 1;
    double first = 1;
    for (size_t i = 0; i < n; ++i)
        first -= w[i];
    double sum = first = std::max(first, kLeastWeight);
    for (size_t i = 0; i < n; ++i)
        sum += w[i] = std::max(w[i], kLeastWeight);
    // Only what is above the least is scaled, so that the least stays.
    const double excess = sum - corners * kLeastWeight;
    const double scale = (1 - corners * kLeastWeight) / excess;
    for (size_t i = 0; i < n; ++i)
        w[i] = kLeastWeight + scale * (w[i] - kLeastWeight);
    return w;
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
    constexpr int kEvaluations = 4;
    constexpr double kTolerance = 0.01;
    double low = edge.difference_a, high = edge.difference_b;
    if (!(low > 0))
        return kLeastCut;
    if (!(high < 0))
        return kGreatestCut;
    // Regula falsi with the Illinois rule: halve the value of an end that stays twice, or it would stay for ever.
    double t_low = 0, t_high = 1, t = low / (low - high);
    int stayed = 0;
    for (int evaluation = 0; evaluation < kEvaluations; ++evaluation) {
        volume.sample(edge.a + t * (edge.b - edge.a), scratch);
        const double f = greatest_value(scratch, edge.A) - greatest_value(scratch, edge.B);
        if (f > 0) {
            t_low = t;
            low = f;
            if (stayed == 1)
                high /= 2;
            stayed = 1;
        } else if (f < 0) {
            t_high = t;
            high = f;
            if (stayed == -1)
                low /= 2;
            stayed = -1;
        } else {
            break;
        }
        const double next = t_low + (t_high - t_low) * low / (low - high);
        const double step = std::abs(next - t);
        t = next;
        if (step < kTolerance)
            break;
    }
    return std::clamp(t, kLeastCut, kGreatestCut);
}

Weights find_centre(const Volume& volume, const SimplexTie& simplex, const Weights& guess, Samples& scratch)
{
    constexpr int kSteps = 2;
    Weights w = hold_inside(guess, simplex.corners);
    for (int step = 0; step < kSteps; ++step) {
        volume.sample_gradient(point_of(simplex, w), scratch);
        Material best[4];
        for (size_t i = 0; i < static_cast<size_t>(simplex.corners); ++i)
            best[i] = best_of(scratch, *simplex.materials[i]);
        const TieEquations tie(scratch, best, simplex.corners);
        Mat3 along_sides = Mat3::Zero();
        for (int j = 0; j < tie.n; ++j)
            along_sides.col(j) = tie.jacobian * (simplex.x[static_cast<size_t>(j) + 1] - simplex.x[0]);
        Vec3 change;
        if (!solve_leading(along_sides, -tie.residual, tie.n, change))
            break;
        for (int i = 0; i < tie.n; ++i)
            w[static_cast<size_t>(i)] += std::clamp(change[i], -0.5, 0.5);
        w = hold_inside(w, simplex.corners);
    }
    return w;
}

std::optional<Vec3> project_to_tie(const Volume& volume, const Vec3& x, const Vec3& start, const MaterialSet& set,
                                   unsigned frozen, double reach, Samples& scratch)
{
    constexpr int kSteps = 5;
    constexpr double kTolerance = 0.02;
    Vec3 free(1, 1, 1);
    for (int axis = 0; axis < 3; ++axis)
        if (frozen >> axis & 1u)
            free[axis] = 0;
    if (set.size() < 2 || set.size() > 4 || set.size() - 1 > free.sum())
        return std::nullopt;
    Material material[4];
    std::copy(set.begin(), set.end(), material);

    // The first step takes the point of the linearised tie closest to x; the next ones go from point to point.
    Vec3 base = x, at = start;
    for (int step = 0; step < kSteps; ++step) {
        volume.sample_gradient(at, scratch);
        const TieEquations tie(scratch, material, set.size());
        const Mat3 masked = tie.jacobian * free.asDiagonal();
        Vec3 multiplier;
        if (!solve_leading(masked * masked.transpose(), -tie.residual - tie.jacobian * (base - at), tie.n, multiplier))
            return std::nullopt;
        const Vec3 next = base + masked.transpose() * multiplier;
        if (!((next - x).norm() <= reach))
            return std::nullopt;
        const bool settled = (next - at).norm() < kTolerance * reach;
        base = at = next;
        if (settled)
            return at;
    }
    return std::nullopt;
}

}  // namespace cleft
