// Parts, borders and volumes of materials: what the neighbours of tetrahedra say, for every number of threads.
#include "mesh/adjacency.hpp"
#include "mesh/materials.hpp"
#include "mesh/surface_points.hpp"
#include "support/bcc.hpp"
#include "support/cmocka.hpp"
#include "support/runs.hpp"

#include <map>

using namespace cleft;
using namespace cleft_test;

namespace
{

using Neighbours = Array<FixedArray<int32_t, 4>>;

// Thick layers of three materials in a box, each in several parts, and single tetrahedra of another here and there.
LabelledMesh layers()
{
    TetMesh box = jittered_bcc(Vec3(17, 15, 12), {17, 15, 12}, 0.1);
    LabelledMesh mesh{std::move(box.points), std::move(box.tets), {}};
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        const double x = mesh.points[mesh.tets[t][0]].x(), y = mesh.points[mesh.tets[t][1]].y();
        const Material layer = static_cast<int>(x / 4) % 2 + (y > 8 ? 1 : 0);
        mesh.material.push_back(t % 97 == 0 ? 3 : layer);
    }
    return mesh;
}

// From one tetrahedron to the next, over faces of one material.
Array<int32_t> walked_parts(const LabelledMesh& mesh, const Neighbours& neighbours)
{
    Array<int32_t> part(mesh.tets.size(), -1), left;
    for (int32_t first = 0; first < mesh.tets.count(); ++first) {
        if (part[first] >= 0)
            continue;
        part[first] = first;
        left.push_back(first);
        while (!left.empty()) {
            const int32_t t = left.back();
            left.pop_back();
            for (const int32_t n : neighbours[t])
                if (n >= 0 && part[n] < 0 && mesh.material[n] == mesh.material[t]) {
                    part[n] = first;
                    left.push_back(n);
                }
        }
    }
    return part;
}

void parts_and_borders_are_those_of_neighbours(void**)
{
    const LabelledMesh mesh = layers();
    assert_true(mesh.tets.size() > 1 << 15);
    const Neighbours neighbours = tet_neighbours(mesh.tets, mesh.points.count());
    const Array<int32_t> wanted = walked_parts(mesh, neighbours);
    std::map<std::pair<Material, Material>, int64_t> borders;
    for (size_t t = 0; t < mesh.tets.size(); ++t)
        for (const int32_t n : neighbours[t])
            if (n >= 0 && mesh.material[t] < mesh.material[n])
                ++borders[{mesh.material[t], mesh.material[n]}];
    for (const int threads : {1, 2, 5}) {
        const MeshParts found = mesh_parts(mesh, with_threads(threads));
        assert_true(found.of_tet == wanted);
        assert_int_equal(found.borders.size(), borders.size());
        auto next = borders.begin();
        for (const Border& b : found.borders) {
            assert_true(std::make_pair(b.first, b.second) == next->first);
            assert_int_equal(b.triangles, (next++)->second);
        }
    }
}

void faces_of_hull_and_borders_have_surface_points(void**)
{
    const LabelledMesh mesh = layers();
    const Neighbours neighbours = tet_neighbours(mesh.tets, mesh.points.count());
    Array<uint8_t> surface(mesh.points.size(), 0), inside(mesh.points.size(), 1);
    for (size_t t = 0; t < mesh.tets.size(); ++t)
        for (size_t i = 0; i < 4; ++i)
            for (const int corner : kFaceCorners[i]) {
                const int32_t n = neighbours[t][i], p = mesh.tets[t][corner];
                if (n < 0)
                    inside[p] = 0;
                if (n < 0 || mesh.material[n] != mesh.material[t])
                    surface[p] = 1;
            }
    for (const int threads : {1, 2, 5}) {
        assert_true(surface_points(mesh, with_threads(threads)) == surface);
        assert_true(points_inside(mesh.tets, mesh.points.size(), with_threads(threads)) == inside);
    }
}

void volumes_are_the_same_for_every_number_of_threads(void**)
{
    const LabelledMesh mesh = layers();
    const Array<double> volumes = material_volumes(mesh, 4);
    assert_true(std::abs(volumes[0] + volumes[1] + volumes[2] + volumes[3] - 17 * 15 * 12) < 1e-8);
    for (const int threads : {2, 5})
        assert_true(material_volumes(mesh, 4, with_threads(threads)) == volumes);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(parts_and_borders_are_those_of_neighbours),
        cmocka_unit_test(faces_of_hull_and_borders_have_surface_points),
        cmocka_unit_test(volumes_are_the_same_for_every_number_of_threads),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
