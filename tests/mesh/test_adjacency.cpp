// Neighbours over faces against a map of all faces, and the axes that a point of the hull may not leave.
#include "mesh/adjacency.hpp"

#include "base/error.hpp"
#include "support/bcc.hpp"
#include "support/cmocka.hpp"

#include <algorithm>
#include <map>
#include <set>

using namespace cleft;
using cleft_test::jittered_bcc;
using cleft_test::Random;

namespace
{

using Face = FixedArray<int32_t, 3>;

Face sorted_face(const Tet& t, size_t corner)
{
    Face f{};
    for (size_t k = 0; k < 3; ++k)
        f[k] = t[kFaceCorners[corner][k]];
    std::sort(f.begin(), f.end());
    return f;
}

Array<FixedArray<int32_t, 4>> neighbours_by_map(const Array<Tet>& tets)
{
    std::map<Face, Array<int32_t>> owners;
    for (size_t t = 0; t < tets.size(); ++t)
        for (size_t i = 0; i < 4; ++i)
            owners[sorted_face(tets[t], i)].push_back(static_cast<int32_t>(t));
    Array<FixedArray<int32_t, 4>> result(tets.size(), {-1, -1, -1, -1});
    for (size_t t = 0; t < tets.size(); ++t)
        for (size_t i = 0; i < 4; ++i)
            for (const int32_t owner : owners[sorted_face(tets[t], i)])
                if (owner != static_cast<int32_t>(t))
                    result[t][i] = owner;
    return result;
}

void shuffle_tets(Array<Tet>& tets, Random& random)
{
    for (size_t i = tets.size(); i > 1; --i)
        std::swap(tets[i - 1], tets[random.below(i)]);
}

bool refuses(const Array<Tet>& tets, int64_t point_count)
{
    try {
        tet_neighbours(tets, point_count);
    } catch (const Error& error) {
        return error.status() == CLEFT_ERROR_INVALID_MESH;
    }
    return false;
}

void faces_look_outward(void**)
{
    const FixedArray<Vec3, 4> x = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    assert_true(orient(x[0], x[1], x[2], x[3]) > 0);
    for (size_t i = 0; i < 4; ++i) {
        const int* f = kFaceCorners[i];
        const double side = orient(x[f[0]], x[f[1]], x[f[2]], x[i]);
        assert_true(side < 0);
    }
}

void neighbours_match_a_map_in_any_order(void**)
{
    TetMesh mesh = jittered_bcc(Vec3(3, 2, 1), {6, 4, 3});
    Random random(5);
    for (int round = 0; round < 4; ++round) {
        const auto expected = neighbours_by_map(mesh.tets);
        const auto found = tet_neighbours(mesh.tets, static_cast<int64_t>(mesh.points.size()));
        assert_true(found == expected);
        shuffle_tets(mesh.tets, random);
    }
}

void two_threads_find_the_same(void**)
{
    const TetMesh mesh = jittered_bcc(Vec3(1, 1, 1), {16, 16, 16});
    const auto count = static_cast<int64_t>(mesh.points.size());
    Run two;
    two.threads = 2;
    assert_true(tet_neighbours(mesh.tets, count, two) == tet_neighbours(mesh.tets, count));
}

// All tetrahedra at one point: the bucket of that point holds three quarters of all faces.
void a_crowded_point_is_no_trouble(void**)
{
    const int32_t rim = 20000;
    Array<Tet> tets;
    for (int32_t i = 0; i < rim; ++i)
        tets.push_back({0, 1, 2 + i, 2 + (i + 1) % rim});
    const auto neighbours = tet_neighbours(tets, rim + 2);
    bool around = true;
    for (int32_t i = 0; i < rim; ++i) {
        const auto& n = neighbours[i];
        around = around && n[2] == (i + 1) % rim && n[3] == (i + rim - 1) % rim && n[0] == -1 && n[1] == -1;
    }
    assert_true(around);
}

void impossible_meshes_are_refused(void**)
{
    assert_true(tet_neighbours({}, 0).empty());
    assert_true(refuses({{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 2, 5}}, 6));
    assert_true(refuses({{0, 1, 2, 4}}, 4));
    assert_true(refuses({{0, 1, 2, -1}}, 4));
    assert_true(refuses({{0, 1, 1, 3}}, 4));
    assert_false(refuses({{0, 1, 2, 3}, {0, 2, 1, 4}}, 5));
}

void axes_freeze_by_the_sides_that_a_point_lies_in(void**)
{
    const Vec3 extent(3, 2, 1);
    const TetMesh mesh = jittered_bcc(extent, {4, 3, 2});
    const auto neighbours = tet_neighbours(mesh.tets, static_cast<int64_t>(mesh.points.size()));
    const Array<uint8_t> frozen = frozen_axes(mesh.points, mesh.tets, neighbours);
    std::set<unsigned> met;
    for (size_t p = 0; p < mesh.points.size(); ++p) {
        unsigned expected = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (mesh.points[p][axis] == 0 || mesh.points[p][axis] == extent[axis])
                expected |= 1u << axis;
        assert_int_equal(frozen[p], expected);
        met.insert(expected);
    }
    assert_int_equal(met.size(), 8);
}

void a_slanted_hull_freezes_all_axes(void**)
{
    const Array<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Array<Tet> tets = {{0, 1, 2, 3}};
    const Array<uint8_t> frozen = frozen_axes(points, tets, tet_neighbours(tets, 4));
    assert_true(frozen == Array<uint8_t>({7, 7, 7, 7}));
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(faces_look_outward),
        cmocka_unit_test(neighbours_match_a_map_in_any_order),
        cmocka_unit_test(two_threads_find_the_same),
        cmocka_unit_test(a_crowded_point_is_no_trouble),
        cmocka_unit_test(impossible_meshes_are_refused),
        cmocka_unit_test(axes_freeze_by_the_sides_that_a_point_lies_in),
        cmocka_unit_test(a_slanted_hull_freezes_all_axes),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
