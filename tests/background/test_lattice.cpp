// The lattice and octree backgrounds: exact walls, exact volume, known angles, boxes of any shape.
#include "support/cmocka.hpp"

#include "background/lattice.hpp"
#include "background/octree.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/quality.hpp"

#include <cmath>

using namespace cleft;

namespace
{

TetMesh lattice_of(int32_t nx, int32_t ny, int32_t nz, const Vec3& spacing, double size)
{
    return lattice_background(Grid{{nx, ny, nz}, spacing}, size, Run());
}

void assert_fills_the_box(const TetMesh& mesh, const Vec3& extent)
{
    double volume = 0, least = 1e300;
    for (const Tet& t : mesh.tets) {
        const auto p = [&](size_t i) { return mesh.points[static_cast<size_t>(t[i])]; };
        const double v = orient(p(0), p(1), p(2), p(3)) / 6;
        least = std::min(least, v);
        volume += v;
    }
    assert_true(least > 0);
    assert_true(std::abs(volume - extent.prod()) < 1e-10 * extent.prod());
    const auto neighbours = tet_neighbours(mesh.tets, static_cast<int64_t>(mesh.points.size()));
    int off_box = 0;
    double area = 0;
    for (size_t t = 0; t < mesh.tets.size(); ++t)
        for (size_t f = 0; f < 4; ++f) {
            if (neighbours[t][f] >= 0)
                continue;
            Vec3 p[3];
            for (int c = 0; c < 3; ++c)
                p[c] = mesh.points[static_cast<size_t>(mesh.tets[t][static_cast<size_t>(kFaceCorners[f][c])])];
            area += 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
            bool on_side = false;
            for (int axis = 0; axis < 3; ++axis)
                for (const double side : {0.0, extent[axis]})
                    on_side = on_side || (p[0][axis] == side && p[1][axis] == side && p[2][axis] == side);
            off_box += !on_side;
        }
    assert_int_equal(off_box, 0);
    const double box_area = 2 * (extent[0] * extent[1] + extent[1] * extent[2] + extent[2] * extent[0]);
    assert_true(std::abs(area - box_area) < 1e-10 * box_area);
}

void boxes_of_any_shape_are_filled_exactly(void**)
{
    const Vec3 one(1, 1, 1);
    assert_fills_the_box(lattice_of(10, 10, 10, one, 2), Vec3(10, 10, 10));
    assert_fills_the_box(lattice_of(17, 9, 23, Vec3(0.7, 1.1, 0.3), 0.8), Vec3(17 * 0.7, 9 * 1.1, 23 * 0.3));
    assert_fills_the_box(lattice_of(40, 40, 1, one, 5), Vec3(40, 40, 1));
    assert_fills_the_box(lattice_of(3, 3, 3, one, 100), Vec3(3, 3, 3));
    assert_fills_the_box(lattice_of(8, 8, 8, Vec3(1e-6, 1e-6, 1e-6), 2e-6), Vec3(8e-6, 8e-6, 8e-6));
}

// h grows from `least` at one point of the box by 0.3 a unit of length: a field of gradation 0.3 with all sizes.
SizingField graded_field(const Grid& grid, const Vec3& centre, double least)
{
    SizingField field;
    field.grid = grid;
    for (int32_t k = 0; k < grid.dims[2]; ++k)
        for (int32_t j = 0; j < grid.dims[1]; ++j)
            for (int32_t i = 0; i < grid.dims[0]; ++i)
                field.h.push_back(static_cast<float>(least + 0.3 * (grid.centre(i, j, k) - centre).norm()));
    return field;
}

void octrees_of_any_shape_are_filled_exactly(void**)
{
    const Grid grids[] = {{{32, 32, 32}, Vec3(1, 1, 1)},
                          {{50, 21, 13}, Vec3(0.5, 1, 2)},
                          {{40, 40, 2}, Vec3(1, 1, 1)},
                          {{1, 1, 1}, Vec3(1, 1, 1)},
                          {{30, 30, 30}, Vec3(1e6, 1e6, 1e6)}};
    for (const Grid& grid : grids) {
        const Vec3 extent = grid.extent();
        for (const double least : {0.02, 0.2})
            for (const Vec3& centre : {Vec3(0, 0, 0), Vec3(0.3, 0.9, 0.5), Vec3(0.5, 0.5, 1)}) {
                const double h = least * std::cbrt(extent.prod()) / 2;
                const TetMesh mesh = octree_background(graded_field(grid, centre.cwiseProduct(extent), h), Run());
                assert_fills_the_box(mesh, extent);
            }
    }
}

double mean_edge(const TetMesh& mesh, const Tet& t)
{
    double sum = 0;
    for (const auto& e : kEdgeCorners)
        sum += (mesh.points[static_cast<size_t>(t[static_cast<size_t>(e[0])])] -
                mesh.points[static_cast<size_t>(t[static_cast<size_t>(e[1])])])
                   .norm();
    return sum / 6;
}

// Sides of leaves are powers of two of each other: whatever the box, the finest must be as fine as the field asks.
void octrees_are_as_fine_as_the_field_at_its_finest(void**)
{
    for (int32_t side = 16; side <= 33; ++side) {
        const Grid grid{{side, side, side + 3}, Vec3(1, 1, 1)};
        SizingField field;
        field.grid = grid;
        for (int32_t k = 0; k < grid.dims[2]; ++k)
            for (int32_t i = 0; i < side * side; ++i)
                field.h.push_back(static_cast<float>(1 + 0.3 * std::max(0, std::abs(k - side / 2) - 2)));
        const TetMesh mesh = octree_background(field, Run());
        double greatest = 0;
        for (const Tet& t : mesh.tets) {
            double middle = 0;
            for (const int32_t corner : t)
                middle += mesh.points[static_cast<size_t>(corner)].z() / 4;
            if (std::abs(middle - side / 2 - 0.5) < 1)
                greatest = std::max(greatest, mean_edge(mesh, t));
        }
        assert_true(greatest > 0.7 && greatest < 1.25);
    }
}

void octree_angles_and_sizes_follow_the_field(void**)
{
    const Grid grid{{48, 48, 48}, Vec3(1, 1, 1)};
    const SizingField field = graded_field(grid, Vec3(10, 20, 30), 0.4);
    const TetMesh mesh = octree_background(field, Run());
    const Quality quality = measure_quality(mesh.points, mesh.tets, Run());
    assert_true(quality.min_dihedral > 44.9);
    assert_true(quality.max_dihedral < 120.1);
    double ratio = 0;
    for (const Tet& t : mesh.tets) {
        Vec3 middle = Vec3::Zero();
        for (const int32_t corner : t)
            middle += mesh.points[static_cast<size_t>(corner)] / 4;
        ratio += mean_edge(mesh, t) / field.at(middle) / static_cast<double>(mesh.tets.size());
    }
    print_message("mean edge over h: %g\n", ratio);
    assert_true(ratio > 0.7 && ratio < 1.3);
}

void cubic_cells_have_the_angles_of_the_lattice(void**)
{
    const TetMesh mesh = lattice_of(16, 16, 16, Vec3(1, 1, 1), 16 / 8.0 * (6 + 8 * std::sqrt(0.75)) / 14);
    const Quality quality = measure_quality(mesh.points, mesh.tets, Run());
    assert_true(std::abs(quality.min_dihedral - 45) < 1e-9);
    assert_true(std::abs(quality.max_dihedral - 120) < 1e-9);
    assert_int_equal(mesh.points.size(), 9 * 9 * 9 + 8 * 8 * 8);
}

void the_mean_edge_is_the_size_asked_for(void**)
{
    const TetMesh mesh = lattice_of(100, 90, 80, Vec3(1, 1, 1), 3.3);
    const Quality quality = measure_quality(mesh.points, mesh.tets, Run());
    assert_true(std::abs(quality.mean_edge - 3.3) < 0.15 * 3.3);
}

void too_fine_a_lattice_is_refused(void**)
{
    cleft_status status = CLEFT_OK;
    try {
        lattice_of(10, 10, 10, Vec3(1, 1, 1), 1e-4);
    } catch (const Error& error) {
        status = error.status();
    }
    assert_int_equal(status, CLEFT_ERROR_TOO_LARGE);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(boxes_of_any_shape_are_filled_exactly),
        cmocka_unit_test(octrees_of_any_shape_are_filled_exactly),
        cmocka_unit_test(octrees_are_as_fine_as_the_field_at_its_finest),
        cmocka_unit_test(octree_angles_and_sizes_follow_the_field),
        cmocka_unit_test(cubic_cells_have_the_angles_of_the_lattice),
        cmocka_unit_test(the_mean_edge_is_the_size_asked_for),
        cmocka_unit_test(too_fine_a_lattice_is_refused),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
