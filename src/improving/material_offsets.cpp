#include "improving/material_offsets.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

namespace cleft
{

std::vector<double> material_offsets(const std::vector<Contact>& contacts, const std::vector<double>& missing)
{
    // Area-weighted graph Laplacian: singular, as offsets that are all equal move nothing. Conjugate gradients from
    // zero stay orthogonal to that.
    const auto n = static_cast<Eigen::Index>(missing.size());
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4 * contacts.size());
    for (const Contact& c : contacts) {
        entries.emplace_back(c.first, c.first, c.area);
        entries.emplace_back(c.second, c.second, c.area);
        entries.emplace_back(c.first, c.second, -c.area);
        entries.emplace_back(c.second, c.first, -c.area);
    }
    Eigen::SparseMatrix<double> laplacian(n, n);
    laplacian.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(laplacian);
    solver.setTolerance(1e-6);
    solver.setMaxIterations(500);
    const Eigen::VectorXd offsets = solver.solve(Eigen::Map<const Eigen::VectorXd>(missing.data(), n));
    return {offsets.data(), offsets.data() + n};
}

}  // namespace cleft
