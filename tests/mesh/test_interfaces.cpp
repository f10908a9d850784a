// The triangles between materials: which there are, how they are wound, and which side of the box they lie in.
#include "mesh/interfaces.hpp"

#include "support/cmocka.hpp"
#include "support/meshes.hpp"
#include "support/near.hpp"

#include <map>
#include <tuple>

using namespace cleft;
using namespace cleft_test;

namespace
{

const Vec3 kExtent(3, 2, 1);

Interfaces extract(const LabelledMesh& mesh, int threads = 1)
{
    Run run;
    run.threads = threads;
    return extract_interfaces(mesh, Vec3(0, 0, 0), kExtent, run);
}

Vec3 twice_area(const LabelledMesh& mesh, const Triangle& t)
{
    const Vec3& a = mesh.points[t[0]];
    return (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a);
}

// Six times the volume between a triangle and the origin.
double six_volumes(const LabelledMesh& mesh, const Triangle& t)
{
    return mesh.points[t[0]].dot(mesh.points[t[1]].cross(mesh.points[t[2]]));
}

Triangle sorted(Triangle t)
{
    std::sort(t.begin(), t.end());
    return t;
}

std::map<Triangle, Array<Material>> materials_of_faces(const LabelledMesh& mesh)
{
    std::map<Triangle, Array<Material>> faces;
    for (size_t t = 0; t < mesh.tets.size(); ++t)
        for (const auto& f : kFaceCorners) {
            const Tet& tet = mesh.tets[t];
            faces[sorted({tet[f[0]], tet[f[1]], tet[f[2]]})].push_back(mesh.material[t]);
        }
    return faces;
}

bool has_corners(const Tet& tet, const Triangle& triangle)
{
    return std::all_of(triangle.begin(), triangle.end(),
                       [&](int32_t p) { return std::find(tet.begin(), tet.end(), p) != tet.end(); });
}

void triangles_are_those_between_two_materials(void**)
{
    const LabelledMesh mesh = good_mesh(4);
    const Interfaces found = extract(mesh);
    size_t between = 0, hull = 0;
    auto faces = materials_of_faces(mesh);
    for (auto& [face, materials] : faces) {
        std::sort(materials.begin(), materials.end());
        hull += materials.size() == 1;
        between += materials.size() == 2 && materials[0] != materials[1];
    }
    assert_int_equal(found.triangles.size(), between);
    assert_int_equal(found.pairs.size(), between);
    assert_int_equal(found.hull.size(), hull);
    assert_int_equal(found.hull_region.size(), hull);
    assert_int_equal(found.hull_side.size(), hull);
    for (size_t i = 0; i < between; ++i) {
        const auto& materials = faces[sorted(found.triangles[i])];
        assert_true(found.pairs[i][0] < found.pairs[i][1]);
        assert_true(materials == Array<Material>({found.pairs[i][0], found.pairs[i][1]}));
        for (size_t s = 0; s < 2; ++s) {
            assert_int_equal(mesh.material[found.tets[i][s]], found.pairs[i][s]);
            assert_true(has_corners(mesh.tets[found.tets[i][s]], found.triangles[i]));
        }
    }
    for (size_t i = 0; i < hull; ++i) {
        assert_true(faces[sorted(found.hull[i])] == Array<Material>({found.hull_region[i]}));
        assert_true(has_corners(mesh.tets[found.hull_tet[i]], found.hull[i]));
    }
}

// By the divergence theorem the triangles around a material, wound outward, give its volume.
void winding_gives_the_volume_of_each_material(void**)
{
    const LabelledMesh mesh = good_mesh(4);
    const Interfaces found = extract(mesh);
    FixedArray<double, 4> by_surface{}, by_tets{};
    for (size_t i = 0; i < found.triangles.size(); ++i) {
        by_surface[found.pairs[i][0]] += six_volumes(mesh, found.triangles[i]);
        by_surface[found.pairs[i][1]] -= six_volumes(mesh, found.triangles[i]);
    }
    for (size_t i = 0; i < found.hull.size(); ++i)
        by_surface[found.hull_region[i]] += six_volumes(mesh, found.hull[i]);
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        const Tet& c = mesh.tets[t];
        by_tets[mesh.material[t]] += orient(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]], mesh.points[c[3]]);
    }
    for (size_t m = 0; m < 4; ++m)
        assert_true(near(by_surface[m], by_tets[m], 1e-11));
}

void the_normal_points_from_the_first_material_to_the_second(void**)
{
    const LabelledMesh mesh = good_mesh(2);  // material 1 where x is greater
    const Interfaces found = extract(mesh);
    Vec3 sum(0, 0, 0);
    for (const Triangle& t : found.triangles)
        sum += twice_area(mesh, t) / 2;
    assert_true(near(sum[0], 2, 1e-12) && near(sum[1], 0, 0.2) && near(sum[2], 0, 0.2));
}

void hull_triangles_know_their_side(void**)
{
    const LabelledMesh mesh = good_mesh(3);
    const Interfaces found = extract(mesh);
    FixedArray<Vec3, 7> sums;
    sums.fill(Vec3(0, 0, 0));
    for (size_t i = 0; i < found.hull.size(); ++i)
        sums[static_cast<int>(found.hull_side[i])] += twice_area(mesh, found.hull[i]) / 2;
    const Vec3 expected[7] = {{-2, 0, 0}, {2, 0, 0}, {0, -3, 0}, {0, 3, 0}, {0, 0, -6}, {0, 0, 6}, {0, 0, 0}};
    for (size_t side = 0; side < 7; ++side)
        assert_true((sums[side] - expected[side]).norm() < 1e-12);
}

void other_is_a_triangle_in_no_side(void**)
{
    LabelledMesh mesh = good_mesh(1);
    remove_tet(mesh, inner_tet(mesh));
    Interfaces found = extract(mesh);
    assert_int_equal(std::count(found.hull_side.begin(), found.hull_side.end(), Side::other), 4);
    assert_true(found.hull_side.back() == Side::other);
    // Sides are recognized by exact coordinates.
    mesh = good_mesh(1);
    mesh.points[side_point(mesh)][2] = 1e-15;
    found = extract(mesh);
    assert_true(std::count(found.hull_side.begin(), found.hull_side.end(), Side::other) >= 4);
}

void everything_is_sorted(void**)
{
    const LabelledMesh mesh = good_mesh(5);
    const Interfaces found = extract(mesh);
    for (size_t i = 1; i < found.triangles.size(); ++i)
        assert_true(std::tie(found.pairs[i - 1], found.triangles[i - 1]) <
                    std::tie(found.pairs[i], found.triangles[i]));
    for (size_t i = 1; i < found.hull.size(); ++i)
        assert_true(std::tie(found.hull_side[i - 1], found.hull_region[i - 1], found.hull[i - 1]) <
                    std::tie(found.hull_side[i], found.hull_region[i], found.hull[i]));
}

void the_order_of_tetrahedra_and_the_threads_do_not_matter(void**)
{
    LabelledMesh mesh = good_mesh(5, kExtent, {18, 12, 9});
    const Interfaces expected = extract(mesh);
    for (size_t t = 0; t < mesh.tets.size() / 2; ++t) {
        std::swap(mesh.tets[t], mesh.tets[mesh.tets.size() - 1 - t]);
        std::swap(mesh.material[t], mesh.material[mesh.tets.size() - 1 - t]);
    }
    const Interfaces found = extract(mesh, 2);
    assert_true(found.triangles == expected.triangles && found.pairs == expected.pairs);
    assert_true(found.hull == expected.hull && found.hull_region == expected.hull_region);
    assert_true(found.hull_side == expected.hull_side);
}

void a_crowded_face_is_refused(void**)
{
    LabelledMesh mesh = good_mesh(2);
    crowd_a_face(mesh);
    bool refused = false;
    try {
        extract(mesh, 2);
    } catch (const Error& error) {
        refused = error.status() == CLEFT_ERROR_INVALID_MESH;
    }
    assert_true(refused);
    assert_true(extract(LabelledMesh()).hull.empty());
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(triangles_are_those_between_two_materials),
        cmocka_unit_test(winding_gives_the_volume_of_each_material),
        cmocka_unit_test(the_normal_points_from_the_first_material_to_the_second),
        cmocka_unit_test(hull_triangles_know_their_side),
        cmocka_unit_test(other_is_a_triangle_in_no_side),
        cmocka_unit_test(everything_is_sorted),
        cmocka_unit_test(the_order_of_tetrahedra_and_the_threads_do_not_matter),
        cmocka_unit_test(a_crowded_face_is_refused),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
