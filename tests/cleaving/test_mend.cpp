// Links find what is pinched, and mending leaves surfaces.
#include "cleaving/link.hpp"
#include "cleaving/mend.hpp"
#include "mesh/point_stars.hpp"
#include "support/bcc.hpp"
#include "support/cmocka.hpp"
#include "support/parts.hpp"
#include "support/pinches.hpp"

#include <numeric>

using namespace cleft;
using namespace cleft_test;

namespace
{

constexpr int32_t kCells = 6;

// label(x) of the centroid of each tetrahedron.
template <class Label>
LabelledMesh labelled_box(const Label& label)
{
    TetMesh box = jittered_bcc(Vec3::Constant(kCells), {kCells, kCells, kCells});
    LabelledMesh mesh{std::move(box.points), std::move(box.tets), {}};
    for (const Tet& t : mesh.tets) {
        const auto x = [&](size_t i) { return mesh.points[static_cast<size_t>(t[i])]; };
        mesh.material.push_back(label((x(0) + x(1) + x(2) + x(3)) / 4));
    }
    return mesh;
}

LabelledMesh random_box(uint64_t labels, uint64_t seed)
{
    Random random(seed);
    return labelled_box([&](const Vec3&) { return static_cast<Material>(random.below(labels)); });
}

Pinches pinches_by_links(const LabelledMesh& mesh)
{
    const PointStars stars(mesh.tets, mesh.points.size(), Run());
    Link link(mesh.points.size());
    Pinches pinches;
    for (int32_t v = 0; v < static_cast<int32_t>(mesh.points.size()); ++v) {
        const PointStars::Range star = stars.at(v);
        link.load(mesh, v, star.first, star.last);
        pinches.edges += static_cast<int64_t>(link.pinched_edges().size());
        pinches.points += link.is_pinched();
    }
    pinches.edges /= 2;
    return pinches;
}

struct Mended {
    LabelledMesh mesh;
    int64_t pinched = 0, changed = 0, left = 0;
};

Mended mended(LabelledMesh mesh)
{
    Array<int32_t> points(mesh.points.size());
    std::iota(points.begin(), points.end(), 0);
    Metrics metrics;
    Run run;
    run.metrics = &metrics;
    mend_interfaces(mesh, points, run);
    const auto noted = [&](const char* name) { return static_cast<int64_t>(metrics.get(name, -1)); };
    return {std::move(mesh), noted("cleaving.pinched"), noted("cleaving.mended"), noted("cleaving.left_pinched")};
}

// Of each label, over faces.
std::vector<size_t> parts_of(const LabelledMesh& mesh, Material labels)
{
    std::vector<size_t> count;
    for (const auto& parts : material_parts(mesh, labels))
        count.push_back(parts.size());
    return count;
}

}  // namespace

static void links_see_what_a_plain_count_sees(void**)
{
    for (const uint64_t labels : {2u, 3u, 5u})
        for (uint64_t seed = 1; seed <= 3; ++seed) {
            const LabelledMesh mesh = random_box(labels, seed);
            const Pinches plain = count_pinches(mesh.tets, mesh.material), found = pinches_by_links(mesh);
            assert_true(plain.edges > 0);
            assert_int_equal(found.edges, plain.edges);
            assert_true(found.points >= plain.points);  // links also see what touches the hull in a point
        }
}

static void a_surface_is_left_alone(void**)
{
    const Mended result = mended(labelled_box([](const Vec3& x) { return x[0] + 0.3 * x[1] < 3 ? 1 : 0; }));
    assert_int_equal(result.pinched, 0);
    assert_int_equal(result.changed, 0);
    assert_int_equal(result.left, 0);
}

// Two bars that touch along an edge of cells come apart or grow together; what each of them is keeps its pieces.
static void bars_that_touch_are_mended(void**)
{
    const LabelledMesh mesh =
        labelled_box([](const Vec3& x) { return (x[0] < 3) == (x[1] < 3) && x[2] > 1 && x[2] < 5 ? 1 : 0; });
    assert_true(count_pinches(mesh.tets, mesh.material).edges > 0);
    const Mended result = mended(mesh);
    const Pinches left = count_pinches(result.mesh.tets, result.mesh.material);
    assert_int_equal(left.edges + left.points, 0);
    assert_int_equal(result.left, 0);
    assert_true(result.changed > 0);
    assert_true(parts_of(result.mesh, 2)[1] <= 2);
    assert_int_equal(parts_of(result.mesh, 2)[0], 1);
}

static void chance_is_mended(void**)
{
    for (const uint64_t labels : {2u, 3u}) {
        const LabelledMesh mesh = random_box(labels, 5);
        const Pinches before = count_pinches(mesh.tets, mesh.material);
        const Mended result = mended(mesh);
        const Pinches after = count_pinches(result.mesh.tets, result.mesh.material);
        assert_true(result.pinched > 0);
        assert_true(20 * after.edges < before.edges);
        assert_true(after.edges + after.points <= 2 * result.left);
        int64_t changed = 0;
        for (size_t t = 0; t < mesh.tets.size(); ++t)
            changed += mesh.material[t] != result.mesh.material[t];
        assert_true(changed > 0 && changed <= result.changed);
        for (const size_t parts : parts_of(result.mesh, static_cast<Material>(labels)))
            assert_true(parts > 0);
    }
}

// The last tetrahedron of a label stays, though it touches its like nowhere.
static void no_label_is_lost(void**)
{
    LabelledMesh mesh = labelled_box([](const Vec3&) { return 0; });
    mesh.material[mesh.material.size() / 2] = 1;
    const Tet single = mesh.tets[mesh.material.size() / 2];
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        const auto shared = std::count_if(mesh.tets[t].begin(), mesh.tets[t].end(), [&](int32_t v) {
            return std::find(single.begin(), single.end(), v) != single.end();
        });
        if (shared == 1)
            mesh.material[t] = 2;
    }
    const Mended result = mended(mesh);
    for (Material m = 0; m < 3; ++m)
        assert_true(std::count(result.mesh.material.begin(), result.mesh.material.end(), m) > 0);
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(links_see_what_a_plain_count_sees),
        cmocka_unit_test(a_surface_is_left_alone),
        cmocka_unit_test(bars_that_touch_are_mended),
        cmocka_unit_test(chance_is_mended),
        cmocka_unit_test(no_label_is_lost),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
