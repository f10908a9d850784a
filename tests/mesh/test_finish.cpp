// What a mesh goes through last: the order of its points and tetrahedra, leaving materials out, and its parts.
#include "mesh/materials.hpp"
#include "mesh/order.hpp"
#include "mesh/strip.hpp"

#include "checking/validate.hpp"
#include "support/cmocka.hpp"
#include "support/meshes.hpp"
#include "support/near.hpp"
#include "support/parts.hpp"

#include <numeric>

using namespace cleft;
using namespace cleft_test;

namespace
{

LabelledMesh ordered(LabelledMesh mesh, int threads = 1)
{
    Run run;
    run.threads = threads;
    order_spatially(mesh, run);
    return mesh;
}

bool same(const LabelledMesh& a, const LabelledMesh& b)
{
    return a.points == b.points && a.tets == b.tets && a.material == b.material;
}

// Mean distance in numbering between the least and the greatest corner.
double mean_span(const LabelledMesh& mesh)
{
    double sum = 0;
    for (const Tet& t : mesh.tets)
        sum += *std::max_element(t.begin(), t.end()) - *std::min_element(t.begin(), t.end());
    return sum / static_cast<double>(mesh.tets.size());
}

// A box of one material with three separate bars of another one across it.
LabelledMesh three_bars()
{
    LabelledMesh mesh = good_mesh(1, Vec3(12, 4, 4), {12, 4, 4});
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        const double x = centroid(mesh, t)[0];
        mesh.material[t] = 2 * ((x > 1 && x < 3) || (x > 5 && x < 6.5) || x > 9);
    }
    return mesh;
}

void ordering_keeps_the_mesh(void**)
{
    LabelledMesh mesh = good_mesh(3);
    mesh.points.insert(mesh.points.begin(), Vec3(1, 1, 0.5));  // in no tetrahedron
    for (Tet& tet : mesh.tets)
        for (int32_t& p : tet)
            ++p;
    const LabelledMesh out = ordered(mesh);
    assert_int_equal(out.points.size(), mesh.points.size() - 1);
    const Run run;
    assert_true(validate(out, true, run).valid());
    const auto before = material_volumes(mesh, 3), after = material_volumes(out, 3);
    for (size_t m = 0; m < 3; ++m)
        assert_true(near(before[m], after[m], 1e-12));
}

void the_order_is_that_of_the_places_alone(void**)
{
    const LabelledMesh mesh = good_mesh(4);
    const LabelledMesh expected = ordered(mesh);
    Random random(9);
    for (int round = 0; round < 5; ++round)
        assert_true(same(ordered(renumbered(mesh, random)), expected));
    assert_true(same(ordered(expected), expected));
}

void the_order_brings_neighbours_together(void**)
{
    Random random(9);
    const LabelledMesh shuffled = renumbered(good_mesh(2, Vec3(3, 2, 1), {18, 12, 6}), random);
    const LabelledMesh out = ordered(shuffled);
    assert_true(mean_span(out) < 0.3 * mean_span(shuffled));
    double step = 0;
    for (size_t p = 1; p < out.points.size(); ++p)
        step += (out.points[p] - out.points[p - 1]).norm();
    assert_true(step / static_cast<double>(out.points.size()) < 2.0 / 6);  // twice the size of a cell
    assert_true(std::is_sorted(out.tets.begin(), out.tets.end()));
}

void ordering_is_the_same_for_two_threads(void**)
{
    const LabelledMesh mesh = good_mesh(4, Vec3(3, 2, 1), {18, 24, 18});
    assert_true(same(ordered(mesh, 1), ordered(mesh, 2)));
}

void ordering_takes_degenerate_meshes(void**)
{
    assert_true(ordered(LabelledMesh()).tets.empty());
    LabelledMesh flat;
    flat.points.assign(4, Vec3(1, 2, 3));
    flat.tets = {{3, 1, 2, 0}};
    flat.material = {0};
    assert_int_equal(ordered(flat).points.size(), 4);
    // So near to each other that the curve does not tell them apart.
    LabelledMesh mesh = good_mesh(2);
    add_tet(mesh, {0, 1, 2, static_cast<int32_t>(mesh.points.size())}, 0);
    mesh.points.push_back(mesh.points[0] + Vec3(1e-9, 0, 0));
    Random random(1);
    assert_true(same(ordered(renumbered(mesh, random)), ordered(mesh)));
}

void strip_but(LabelledMesh& mesh, const Array<char>& keep)
{
    strip(mesh.points, mesh.tets, mesh.material, [&](int32_t m) { return keep[m] != 0; });
}

void stripping_leaves_the_kept_materials(void**)
{
    const LabelledMesh mesh = good_mesh(4);
    LabelledMesh out = mesh;
    strip_but(out, {0, 1, 0, 1});
    const auto before = material_volumes(mesh, 4), after = material_volumes(out, 4);
    assert_true(after[0] == 0 && after[2] == 0 && after[1] == before[1] && after[3] == before[3]);
    const Run run;
    assert_true(validate(out, false, run).valid());

    LabelledMesh all = mesh, none = mesh;
    strip_but(all, {1, 1, 1, 1});
    assert_true(same(all, mesh));
    strip_but(none, {0, 0, 0, 0});
    assert_true(none.points.empty() && none.tets.empty() && none.material.empty());
}

void parts_are_joined_by_faces(void**)
{
    const LabelledMesh mesh = three_bars();
    const auto parts = material_parts(mesh, 3);
    assert_int_equal(parts.size(), 3);
    assert_int_equal(parts[0].size(), 3);
    assert_int_equal(parts[1].size(), 0);
    assert_int_equal(parts[2].size(), 3);
    assert_true(near(parts[2][0], 3 * 16, 3) && near(parts[2][1], 2 * 16, 3) && near(parts[2][2], 1.5 * 16, 3));
    const auto volumes = material_volumes(mesh, 3);
    for (size_t m = 0; m < 3; ++m) {
        assert_true(std::is_sorted(parts[m].rbegin(), parts[m].rend()));
        assert_true(near(std::accumulate(parts[m].begin(), parts[m].end(), 0.0), volumes[m], 1e-10));
    }
    assert_true(near(volumes[0] + volumes[2], 12 * 16, 1e-10));
}

// Fills from each tetrahedron over its neighbours of the same material.
size_t parts_by_filling(const LabelledMesh& mesh)
{
    const auto neighbours = tet_neighbours(mesh.tets, static_cast<int64_t>(mesh.points.size()));
    Array<char> seen(mesh.tets.size(), 0);
    size_t parts = 0;
    for (int64_t start = 0; start < mesh.tets.count(); ++start) {
        parts += !seen[start];
        Array<int64_t> stack = {start};
        while (!stack.empty()) {
            const int64_t t = stack.back();
            stack.pop_back();
            if (seen[t])
                continue;
            seen[t] = 1;
            for (const int32_t n : neighbours[t])
                if (n >= 0 && mesh.material[n] == mesh.material[t])
                    stack.push_back(n);
        }
    }
    return parts;
}

size_t number_of_parts(const LabelledMesh& mesh)
{
    size_t parts = 0;
    for (const auto& volumes : material_parts(mesh, 5))
        parts += volumes.size();
    return parts;
}

void parts_of_noise_match_a_flood_fill(void**)
{
    LabelledMesh mesh = good_mesh(5);
    assert_int_equal(number_of_parts(mesh), parts_by_filling(mesh));
    assert_true(number_of_parts(mesh) > 100);
    // What is left touches over edges and points that nothing else is around.
    strip_but(mesh, {0, 1, 0, 0, 1});
    assert_int_equal(number_of_parts(mesh), parts_by_filling(mesh));
    strip_but(mesh, {0, 1, 0, 0, 0});
    assert_int_equal(number_of_parts(mesh), parts_by_filling(mesh));
}

// Two tetrahedra that share an edge only.
void an_edge_does_not_join(void**)
{
    LabelledMesh mesh;
    mesh.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    mesh.tets = {{0, 2, 3, 1}, {0, 4, 5, 1}};
    mesh.material = {0, 0};
    assert_int_equal(material_parts(mesh, 1)[0].size(), 2);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(ordering_keeps_the_mesh),
        cmocka_unit_test(the_order_is_that_of_the_places_alone),
        cmocka_unit_test(the_order_brings_neighbours_together),
        cmocka_unit_test(ordering_is_the_same_for_two_threads),
        cmocka_unit_test(ordering_takes_degenerate_meshes),
        cmocka_unit_test(stripping_leaves_the_kept_materials),
        cmocka_unit_test(parts_are_joined_by_faces),
        cmocka_unit_test(parts_of_noise_match_a_flood_fill),
        cmocka_unit_test(an_edge_does_not_join),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
