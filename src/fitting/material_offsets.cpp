// Solves the Laplace equation on the graph of materials that touch, with the areas of contact as weights.
#include "fitting/material_offsets.hpp"

#include "base/disjoint_sets.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

namespace cleft
{

namespace
{

// By material: the same number for all that touch, directly or over others.
Array<int32_t> groups_in_touch(const Array<SharedArea>& shared, size_t materials)
{
    DisjointSets sets(materials);
    for (const SharedArea& c : shared)
        sets.join(c.first, c.second);
    return sets.take();
}

// What one material wins another loses, so a group in touch cannot win together: what it misses in sum (the volume of a
// label that is not in the mesh; rounding) is taken off, by areas. Without that the system has no solution, and
// conjugate gradients run away.
Eigen::VectorXd attainable(const Array<SharedArea>& shared, const Array<double>& missing)
{
    const size_t n = missing.size();
    const Array<int32_t> group = groups_in_touch(shared, n);
    const auto of = [&](size_t m) { return group[m]; };
    Array<double> area(n, 0), group_area(n, 0), group_missing(n, 0);
    for (const SharedArea& c : shared) {
        area[c.first] += c.area;
        area[c.second] += c.area;
    }
    for (size_t m = 0; m < n; ++m) {
        group_area[of(m)] += area[m];
        group_missing[of(m)] += missing[m];
    }
    Eigen::VectorXd out(static_cast<Eigen::Index>(n));
    for (size_t m = 0; m < n; ++m) {
        const double share = group_area[of(m)] > 0 ? area[m] / group_area[of(m)] : 0;
        out[static_cast<Eigen::Index>(m)] = area[m] > 0 ? missing[m] - share * group_missing[of(m)] : 0;
    }
    return out;
}

}  // namespace

Array<double> material_offsets(const Array<SharedArea>& shared, const Array<double>& missing)
{
    // Area-weighted graph Laplacian: singular, as offsets that are all equal move nothing. Conjugate gradients from
    // zero stay orthogonal to that.
    const auto n = static_cast<Eigen::Index>(missing.size());
    Array<Eigen::Triplet<double>> entries;
    entries.reserve(4 * shared.size());
    for (const SharedArea& c : shared) {
        entries.emplace_back(c.first, c.first, c.area);
        entries.emplace_back(c.second, c.second, c.area);
        entries.emplace_back(c.first, c.second, -c.area);
        entries.emplace_back(c.second, c.first, -c.area);
    }
    Eigen::SparseMatrix<double> laplacian(n, n);
    laplacian.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(laplacian);
    // The next round corrects what this one leaves, so six digits are more than enough. The limit of iterations bounds
    // the time for long chains of labels.
    solver.setTolerance(1e-6);
    solver.setMaxIterations(500);
    const Eigen::VectorXd offsets = solver.solve(attainable(shared, missing));
    return {offsets.data(), offsets.data() + n};
}

}  // namespace cleft
