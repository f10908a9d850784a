// Every label pattern, vertex order and snap state of one tetrahedron and of two that share a face, through the code
// that makes the output: volumes add up, every piece is positive, the hull is that of the background, the pieces fit.
#include "cleaving/assemble.hpp"
#include "cleaving/find_centres.hpp"
#include "cleaving/flat_cuts.hpp"

#include "cleaving/split_tet.hpp"
#include "mesh/quality.hpp"
#include "support/cmocka.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <map>

using namespace cleft;
using cleft_test::Random;

namespace
{

const Run kRun;

Volume some_volume()
{
    const uint8_t voxels[8] = {0, 1, 2, 3, 4, 0, 1, 2};
    Grid grid;
    grid.dims = {2, 2, 2};
    return Volume::from_labels(VoxelType::uint8, voxels, grid, 5, kRun);
}

// A tetrahedron and, with five points, a second one behind the face opposite corner 0.
TetMesh background(size_t points)
{
    const std::array<Vec3, 5> x = {Vec3(0.1, 0.2, 0.1), Vec3(1.5, 0.2, 0.3), Vec3(0.5, 1.7, 0.2), Vec3(0.6, 0.5, 1.4),
                                   Vec3(1.8, 1.6, 1.5)};
    TetMesh mesh;
    mesh.points.assign(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(points));
    mesh.tets = {{0, 1, 2, 3}};
    if (points == 5)
        mesh.tets.push_back({4, 1, 3, 2});
    return mesh;
}

TetMesh renumbered(const TetMesh& mesh, const Array<int32_t>& number)
{
    TetMesh out = mesh;
    for (size_t v = 0; v < number.size(); ++v)
        out.points[number[v]] = mesh.points[v];
    for (Tet& t : out.tets)
        for (int32_t& v : t)
            v = number[v];
    return out;
}

Centres unsnapped(const Volume& volume, const TetMesh& mesh, const Array<Material>& labels)
{
    Array<MaterialSet> materials;
    for (const Material m : labels)
        materials.emplace_back(m);
    Centres c{volume, mesh.tets, mesh.points, materials, SampleStore({}, Array<uint16_t>(labels.size(), 0)), {}, {}, {},
              {},     {},        {},          {}};
    list_centres(c, kRun);
    choose_fans(c, kRun);
    return c;
}

// Without the samples and doubts, which nothing here reads.
Centres copy_of(const Centres& c)
{
    return {c.volume,
            c.tets,
            c.points,
            c.materials,
            SampleStore({}, Array<uint16_t>(c.points.size(), 0)),
            c.edges,
            c.faces,
            c.mixed,
            c.mixed_of,
            c.stencils,
            c.fans,
            c.kept,
            Array<uint8_t>(c.points.size(), 0)};
}

void place_cuts_at_random(Centres& c, Random& random)
{
    for (CutEdge& e : c.edges)
        e.t = random.between(kLeastCut, kGreatestCut);
}

// Digit e of `state` in base 3: edge e stays cut, or its lower or its upper end takes over the materials of the other.
void snap_by_state(Centres& c, int64_t state)
{
    const Array<MaterialSet> before = c.materials;
    for (const CutEdge& e : c.edges) {
        const auto lower = static_cast<size_t>(e.lower), upper = static_cast<size_t>(e.upper);
        if (state % 3 == 1)
            c.materials[lower].unite(before[upper]);
        if (state % 3 == 2)
            c.materials[upper].unite(before[lower]);
        state /= 3;
    }
    for (CutEdge& e : c.edges)
        e.is_cut = disjoint(c.materials_of(e.lower), c.materials_of(e.upper));
    choose_fans(c, kRun);
}

int64_t snap_states(const Centres& c)
{
    int64_t states = 1;
    for (size_t e = 0; e < c.edges.size(); ++e)
        states *= 3;
    return states;
}

// Labels up to renaming: each vertex has one of those before it, or the next new one.
void for_each_labelling(size_t vertices, Array<Material>& labels, Material next,
                        const std::function<void(const Array<Material>&)>& visit)
{
    if (labels.size() == vertices) {
        visit(labels);
        return;
    }
    for (Material m = 0; m <= next; ++m) {
        labels.push_back(m);
        for_each_labelling(vertices, labels, std::max(next, m + 1), visit);
        labels.pop_back();
    }
}

double total_volume(const Array<Vec3>& points, const Array<Tet>& tets, double& least)
{
    double sum = 0;
    for (const Tet& t : tets) {
        const auto p = [&](size_t i) -> const Vec3& { return points[t[i]]; };
        const double volume = orient(p(0), p(1), p(2), p(3)) / 6;
        least = std::min(least, volume);
        sum += volume;
    }
    return sum;
}

// Area of the faces of one tetrahedron only; negative if a face has more than two.
double hull_area(const Array<Vec3>& points, const Array<Tet>& tets)
{
    std::map<std::array<int32_t, 3>, int> owners;
    for (const Tet& t : tets)
        for (const auto& corners : kFaceCorners) {
            std::array<int32_t, 3> f{};
            for (size_t k = 0; k < 3; ++k)
                f[k] = t[corners[k]];
            std::sort(f.begin(), f.end());
            ++owners[f];
        }
    double area = 0;
    for (const auto& [f, count] : owners) {
        const auto p = [&, &face = f](size_t i) -> const Vec3& { return points[face[i]]; };
        if (count > 2)
            return -1;
        if (count == 1)
            area += (p(1) - p(0)).cross(p(2) - p(0)).norm() / 2;
    }
    return area;
}

struct Tally {
    int64_t cases = 0, wrong_volume = 0, not_positive = 0, wrong_hull = 0, wrong_material = 0, most_cuts = 0;
};

// Each vertex lies in a tetrahedron of one of its materials, and no material appears that no vertex has.
bool materials_belong(const Centres& c, const LabelledMesh& mesh)
{
    MaterialSet all;
    for (const MaterialSet& m : c.materials)
        all.unite(m);
    for (const Material m : mesh.material)
        if (disjoint(MaterialSet(m), all))
            return false;
    for (size_t v = 0; v < c.points.size(); ++v) {
        bool found = false;
        for (size_t t = 0; t < mesh.tets.size(); ++t)
            for (const int32_t p : mesh.tets[t])
                found |= p == static_cast<int32_t>(v) && !disjoint(MaterialSet(mesh.material[t]), c.materials[v]);
        if (!found)
            return false;
    }
    return true;
}

void check(const Centres& c, double volume, double area, bool snapped, Tally& tally)
{
    const LabelledMesh mesh = assemble(c, kRun);
    double least = 1;
    ++tally.cases;
    tally.wrong_volume += std::abs(total_volume(mesh.points, mesh.tets, least) - volume) > 1e-12;
    tally.not_positive += !(least > 1e-9);
    tally.wrong_hull += std::abs(hull_area(mesh.points, mesh.tets) - area) > 1e-12;
    if (!snapped)
        tally.wrong_material += !materials_belong(c, mesh);
    tally.most_cuts = std::max(tally.most_cuts, static_cast<int64_t>(c.edges.size()));
}

Tally go_through_all(const TetMesh& original, bool all_orders)
{
    const Volume volume = some_volume();
    Random random(2);
    Tally tally;
    double least = 1;
    const double whole = total_volume(original.points, original.tets, least),
                 area = hull_area(original.points, original.tets);
    Array<int32_t> number;
    for (size_t v = 0; v < original.points.size(); ++v)
        number.push_back(static_cast<int32_t>(v));
    do {
        const TetMesh mesh = renumbered(original, number);
        Array<Material> labels;
        for_each_labelling(mesh.points.size(), labels, 0, [&](const Array<Material>& of_vertices) {
            const Centres whole_cuts = unsnapped(volume, mesh, of_vertices);
            for (int64_t state = 0; state < snap_states(whole_cuts); ++state) {
                Centres c = copy_of(whole_cuts);
                place_cuts_at_random(c, random);
                snap_by_state(c, state);
                check(c, whole, area, state > 0, tally);
            }
        });
    } while (all_orders && std::next_permutation(number.begin(), number.end()));
    return tally;
}

void assert_no_fault(const Tally& tally)
{
    assert_int_equal(tally.wrong_volume, 0);
    assert_int_equal(tally.not_positive, 0);
    assert_int_equal(tally.wrong_hull, 0);
    assert_int_equal(tally.wrong_material, 0);
}

void one_tetrahedron_in_all_states(void**)
{
    const Tally tally = go_through_all(background(4), true);
    assert_no_fault(tally);
    // 15 labellings in 24 orders, with 3 states of every cut: 3^6, 6 with 3^5, 3 with 3^4, 4 with 3^3, 1 with none.
    assert_int_equal(tally.cases, 24 * (729 + 6 * 243 + 3 * 81 + 4 * 27 + 1));
    assert_int_equal(tally.most_cuts, 6);
}

void two_tetrahedra_at_a_face_in_all_states(void**)
{
    const Tally tally = go_through_all(background(5), false);
    assert_no_fault(tally);
    assert_true(tally.cases > 50000);
    assert_int_equal(tally.most_cuts, 9);
}

// With one material a vertex and nothing snapped every piece has the material of the vertex that it touches.
void unsnapped_pieces_have_the_material_of_their_vertex(void**)
{
    const Volume volume = some_volume();
    const TetMesh mesh = background(5);
    const Centres c = unsnapped(volume, mesh, {0, 1, 2, 3, 4});
    const LabelledMesh out = assemble(c, kRun);
    assert_int_equal(out.tets.size(), 48);
    for (size_t t = 0; t < out.tets.size(); ++t) {
        const int32_t vertex = *std::min_element(out.tets[t].begin(), out.tets[t].end());
        assert_true(vertex < 5);
        assert_int_equal(out.material[t], vertex);
    }
}

// A tetrahedron too thin to be split keeps its volume: its cuts are given up.
void cuts_of_slivers_are_given_up(void**)
{
    const Volume volume = some_volume();
    TetMesh mesh = background(5);
    mesh.points[0] = (mesh.points[1] + mesh.points[2] + mesh.points[3]) / 3;
    mesh.points[0] -= 1e-10 * (mesh.points[4] - mesh.points[0]);
    Centres c = unsnapped(volume, mesh, {0, 1, 2, 3, 4});
    assert_true(give_up_flat_cuts(c, {}, kRun) > 0);
    const LabelledMesh out = assemble(c, kRun);
    double least = 1, least_before = 1;
    const double before = total_volume(mesh.points, mesh.tets, least_before);
    assert_true(std::abs(total_volume(out.points, out.tets, least) - before) < 1e-12);
    assert_true(least > 1e-12);
    assert_true(std::abs(hull_area(out.points, out.tets) - hull_area(mesh.points, mesh.tets)) < 1e-9);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(one_tetrahedron_in_all_states),
        cmocka_unit_test(two_tetrahedra_at_a_face_in_all_states),
        cmocka_unit_test(unsnapped_pieces_have_the_material_of_their_vertex),
        cmocka_unit_test(cuts_of_slivers_are_given_up),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
