/* deal.II on a mesh in parts: the potential about a ball that conducts better, against the exact solution.
 *
 * The parts become a parallel::fullydistributed::Triangulation in memory. It wants one layer more than a part has: all
 * tetrahedra at the points of a rank's own ones. The ranks send each other these first (cells.hpp). Elements are
 * linear, and conjugate gradients with algebraic multigrid solve the system. The program halves the edge length, and
 * fails if the error does not fall by its square.
 */
#include "../ball_in_field.h"
#include "cells.hpp"

#include <deal.II/base/function.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/fully_distributed_tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/grid/tria_description.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/petsc_precondition.h>
#include <deal.II/lac/petsc_solver.h>
#include <deal.II/lac/petsc_sparse_matrix.h>
#include <deal.II/lac/petsc_vector.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/numerics/vector_tools.h>

#include <iostream>
#include <set>
#include <stdexcept>

using namespace dealii;
using Mesh = parallel::fullydistributed::Triangulation<3>;
using MpiVector = PETScWrappers::MPI::Vector;

namespace
{

const MPI_Comm comm = MPI_COMM_WORLD;
constexpr types::boundary_id hull = 1;

void print(const std::string& sentence)
{
    if (Utilities::MPI::this_mpi_process(comm) == 0)
        std::cout << sentence << std::endl;
}

/* What deal.II wants to know: the points, and each cell with its number, its rank and its label. */
TriangulationDescription::Description<3, 3> describe(const std::vector<Cell>& cells)
{
    TriangulationDescription::Description<3, 3> out;
    std::map<std::int64_t, unsigned int> points;
    out.comm = comm;
    out.cell_infos.resize(1);
    for (const Cell& cell : cells) {
        dealii::CellData<3> corners(4);
        TriangulationDescription::CellData<3> info;
        for (int c = 0; c < 4; ++c) {
            const auto [place, is_new] = points.emplace(cell.points[c], points.size());
            if (is_new)
                out.coarse_cell_vertices.emplace_back(cell.places[c][0], cell.places[c][1], cell.places[c][2]);
            corners.vertices[c] = place->second;
        }
        corners.material_id = static_cast<types::material_id>(cell.label);
        corners.manifold_id = numbers::flat_manifold_id;
        info.id = CellId(cell.number, {}).to_binary<3>();
        info.subdomain_id = info.level_subdomain_id = cell.rank;
        info.manifold_id = numbers::flat_manifold_id;
        info.manifold_line_ids.fill(numbers::flat_manifold_id);
        info.manifold_quad_ids.fill(numbers::flat_manifold_id);
        out.coarse_cells.push_back(corners);
        out.coarse_cell_index_to_coarse_cell_id.push_back(cell.number);
        out.cell_infos[0].push_back(info);
    }
    return out;
}

/* Faces with one cell lie on the hull, or where the cells of other ranks end that this one knows. The latter have no
 * point of an own cell. */
void mark_hull(Mesh& mesh)
{
    std::set<unsigned int> own;
    for (const auto& cell : mesh.active_cell_iterators())
        if (cell->is_locally_owned())
            for (const unsigned int c : cell->vertex_indices())
                own.insert(cell->vertex_index(c));
    for (const auto& cell : mesh.active_cell_iterators())
        for (const auto& face : cell->face_iterators())
            if (face->at_boundary())
                for (const unsigned int c : face->vertex_indices())
                    if (own.count(face->vertex_index(c)))
                        face->set_boundary_id(hull);
}

/* The volume of each label as deal.II has it, which must be that of the part. */
void check_volumes(const Mesh& mesh, const double* expected)
{
    std::vector<double> volumes(BALL_LABELS + 1);
    for (const auto& cell : mesh.active_cell_iterators())
        if (cell->is_locally_owned())
            volumes[cell->material_id()] += cell->measure();
    Utilities::MPI::sum(volumes, comm, volumes);
    for (int label = 1; label <= BALL_LABELS; ++label) {
        print("label " + std::to_string(label) + ": volume " + std::to_string(volumes[label]));
        if (std::abs(volumes[label] - expected[label]) > 1e-12)
            throw std::runtime_error("the volume of a label is not that of Cleft");
    }
}

class Exact : public Function<3>
{
public:
    double value(const Point<3>& p, unsigned int) const override
    {
        const double x[3] = {p[0], p[1], p[2]};
        return ball_exact(x);
    }
};

/* Solves, and gives the error in the L2 norm. */
class Problem
{
public:
    explicit Problem(const Mesh& mesh) : mesh_(mesh), dofs_(mesh)
    {
        dofs_.distribute_dofs(element_);
        own_ = dofs_.locally_owned_dofs();
        DoFTools::extract_locally_relevant_dofs(dofs_, relevant_);
        constraints_.reinit(relevant_);
        VectorTools::interpolate_boundary_values(mapping_, dofs_, hull, Exact(), constraints_);
        constraints_.close();
        DynamicSparsityPattern pattern(relevant_);
        DoFTools::make_sparsity_pattern(dofs_, pattern, constraints_, false);
        SparsityTools::distribute_sparsity_pattern(pattern, own_, comm, relevant_);
        matrix_.reinit(own_, own_, pattern, comm);
        load_.reinit(own_, comm);
    }

    void assemble()
    {
        FEValues<3> values(mapping_, element_, QGaussSimplex<3>(1), update_gradients | update_JxW_values);
        FullMatrix<double> matrix(4, 4);
        dealii::Vector<double> load(4);
        std::vector<types::global_dof_index> numbers(4);
        for (const auto& cell : dofs_.active_cell_iterators()) {
            if (!cell->is_locally_owned())
                continue;
            values.reinit(cell);
            const double weight = ball_conductivity(cell->material_id()) * values.JxW(0);
            for (unsigned int a = 0; a < 4; ++a)
                for (unsigned int b = 0; b < 4; ++b)
                    matrix(a, b) = weight * (values.shape_grad(a, 0) * values.shape_grad(b, 0));
            cell->get_dof_indices(numbers);
            constraints_.distribute_local_to_global(matrix, load, numbers, matrix_, load_);
        }
        matrix_.compress(VectorOperation::add);
        load_.compress(VectorOperation::add);
    }

    double solve()
    {
        MpiVector solution(own_, comm), seen(own_, relevant_, comm);
        SolverControl control(1000, 1e-10 * load_.l2_norm());
        PETScWrappers::SolverCG solver(control, comm);
        PETScWrappers::PreconditionBoomerAMG preconditioner(matrix_, {true});
        solver.solve(matrix_, solution, load_, preconditioner);
        constraints_.distribute(solution);
        seen = solution;
        dealii::Vector<float> errors(mesh_.n_active_cells());
        VectorTools::integrate_difference(mapping_, dofs_, seen, Exact(), errors, QGaussSimplex<3>(4),
                                          VectorTools::L2_norm);
        const double error = VectorTools::compute_global_error(mesh_, errors, VectorTools::L2_norm);
        print(std::to_string(control.last_step()) + " steps, error " + std::to_string(error));
        return error;
    }

private:
    const Mesh& mesh_;
    FE_SimplexP<3> element_{1};
    MappingFE<3> mapping_{element_};
    DoFHandler<3> dofs_;
    IndexSet own_, relevant_;
    AffineConstraints<double> constraints_;
    PETScWrappers::MPI::SparseMatrix matrix_;
    MpiVector load_;
};

double error_of_size(double size)
{
    double volumes[BALL_LABELS + 1];
    cleft_part* part = ball_part(comm, size, 1);
    if (!part)
        throw std::runtime_error("there is no mesh");
    ball_volumes(comm, part, volumes);
    Mesh mesh(comm);
    mesh.create_triangulation(describe(relevant_cells(comm, part)));
    cleft_part_destroy(part);
    mark_hull(mesh);
    check_volumes(mesh, volumes);
    Problem problem(mesh);
    problem.assemble();
    return problem.solve();
}

}  // namespace

int main(int argc, char** argv)
{
    const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
    try {
        const double coarse = error_of_size(0.24), fine = error_of_size(0.12);
        print("half the edges, and the error falls to " + std::to_string(fine / coarse));
        return !(fine < 0.3 * coarse && fine < 0.005);
    } catch (const std::exception& e) {
        std::cerr << e.what() << std::endl;
        MPI_Abort(comm, 1);
    }
}
