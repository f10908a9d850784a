// Meshes labels by Mesh_3 of CGAL, and prints what each step took: what benchmarks/performance.py compares Cleft with.
// CGAL is under the GPL, so this program is no part of Cleft: nothing links, installs or packs it.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Image_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "base/process_figures.hpp"

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain, CGAL::Default, CGAL::Parallel_tag>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

constexpr double kSliverBound = 10;  // degrees, as in the example of optimization in CGAL's manual
constexpr double kFacetAngle = 30;   // degrees: the greatest for which refinement is known to end
constexpr double kRadiusEdge = 3;    // as in the manual's examples with labels; below 2 refinement need not end

struct Arguments {
    std::string file;
    unsigned dims[3];
    double spacing[3];
    double facet_size;
    double facet_distance;
    double cell_size;
    unsigned threads;
};

Arguments parsed(char** texts)
{
    Arguments arguments{};
    arguments.file = *texts++;
    for (unsigned& dim : arguments.dims)
        dim = static_cast<unsigned>(std::stoul(*texts++));
    for (double& length : arguments.spacing)
        length = std::stod(*texts++);
    arguments.facet_size = std::stod(*texts++);
    arguments.facet_distance = std::stod(*texts++);
    arguments.cell_size = std::stod(*texts++);
    arguments.threads = static_cast<unsigned>(std::stoul(*texts++));
    return arguments;
}

// Sixteen bits a voxel, x fastest. CGAL does not mesh label 0, which is also what it finds outside.
CGAL::Image_3 read_labels(const Arguments& arguments)
{
    const auto& [nx, ny, nz] = arguments.dims;
    const auto& [x, y, z] = arguments.spacing;
    CGAL::Image_3 image;
    if (!image.read_raw(arguments.file.c_str(), nx, ny, nz, x, y, z, 0, 2, WK_FIXED, SGN_UNSIGNED))
        throw std::runtime_error("'" + arguments.file + "' cannot be read");
    return image;
}

// Does one step, and prints its figures.
template <typename Step>
void measure(const char* name, const Complex& complex, const Step& step)
{
    const auto begin = std::chrono::steady_clock::now();
    const double cpu_begin = cleft::process_cpu_seconds();
    step();
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    std::printf("  \"%s\": {\"seconds\": %.4f, \"cpu_seconds\": %.4f, \"peak_bytes\": %.0f, \"tets\": %zu},\n", name,
                passed.count(), cleft::process_cpu_seconds() - cpu_begin, cleft::process_peak_bytes(),
                static_cast<std::size_t>(complex.number_of_cells_in_complex()));
}

double least_dihedral_angle(const Complex& complex)
{
    double least = 180;
    for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell) {
        const auto point = [&](int corner) { return cell->vertex(corner)->point().point(); };
        const int edges[6][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}};
        for (const auto& [a, b, c, d] : edges)
            least = std::min(least, std::abs(CGAL::approximate_dihedral_angle(point(a), point(b), point(c), point(d))));
    }
    return least;
}

void mesh(const Arguments& arguments)
{
    namespace parameters = CGAL::parameters;
    const CGAL::Image_3 image = read_labels(arguments);
    Complex complex;
    const Domain domain = Domain::create_labeled_image_mesh_domain(image);
    const Criteria criteria(parameters::facet_angle = kFacetAngle, parameters::facet_size = arguments.facet_size,
                            parameters::facet_distance = arguments.facet_distance,
                            parameters::cell_radius_edge_ratio = kRadiusEdge,
                            parameters::cell_size = arguments.cell_size);
    std::puts("{");
    measure("refine", complex, [&] {
        complex = CGAL::make_mesh_3<Complex>(domain, criteria, parameters::no_perturb(), parameters::no_exude());
    });
    std::printf("  \"refined_min_dihedral\": %.6f,\n", least_dihedral_angle(complex));
    measure("perturb", complex,
            [&] { CGAL::perturb_mesh_3(complex, domain, parameters::sliver_bound = kSliverBound); });
    measure("exude", complex, [&] { CGAL::exude_mesh_3(complex, parameters::sliver_bound = kSliverBound); });
    std::printf("  \"threads\": %u,\n  \"min_dihedral\": %.6f\n}\n", arguments.threads, least_dihedral_angle(complex));
}

}  // namespace

int main(int count, char** texts)
{
    if (count != 12) {
        std::fprintf(stderr, "usage: cgal_mesh FILE NX NY NZ DX DY DZ FACET_SIZE FACET_DISTANCE CELL_SIZE THREADS\n");
        return 2;
    }
    try {
        const Arguments arguments = parsed(texts + 1);
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, arguments.threads);
        mesh(arguments);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "cgal_mesh: %s\n", error.what());
        return 1;
    }
}
