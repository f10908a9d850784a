// Good meshes, and the same meshes broken in one way each.
#pragma once

#include "base/array.hpp"
#include "mesh/adjacency.hpp"
#include "support/bcc.hpp"

#include <string>

namespace cleft_test
{

using cleft::LabelledMesh;
using cleft::Tet;
using cleft::Vec3;

inline Vec3 centroid(const LabelledMesh& mesh, size_t t)
{
    Vec3 sum(0, 0, 0);
    for (const int32_t p : mesh.tets[t])
        sum += mesh.points[p];
    return sum / 4;
}

// Two materials on both sides of a plane, or (materials > 2) of random tetrahedra.
inline LabelledMesh good_mesh(int materials, const Vec3& extent = Vec3(3, 2, 1),
                              const std::array<int32_t, 3>& cells = {6, 4, 3})
{
    const cleft::TetMesh background = jittered_bcc(extent, cells);
    LabelledMesh mesh{background.points, background.tets, {}};
    Random random(17);
    for (size_t t = 0; t < mesh.tets.size(); ++t)
        mesh.material.push_back(materials > 2 ? static_cast<int32_t>(random.below(static_cast<uint64_t>(materials)))
                                              : (materials == 2 && centroid(mesh, t)[0] > extent[0] / 2));
    return mesh;
}

// A tetrahedron with no point on the hull of good_mesh.
inline size_t inner_tet(const LabelledMesh& mesh)
{
    const auto neighbours = cleft::tet_neighbours(mesh.tets, static_cast<int64_t>(mesh.points.size()));
    const cleft::Array<uint8_t> frozen = cleft::frozen_axes(mesh.points, mesh.tets, neighbours);
    for (size_t t = mesh.tets.size() / 2; t < mesh.tets.size(); ++t) {
        const Tet& tet = mesh.tets[t];
        if (!frozen[tet[0]] && !frozen[tet[1]] && !frozen[tet[2]] && !frozen[tet[3]])
            return t;
    }
    return mesh.tets.size();
}

inline void add_tet(LabelledMesh& mesh, const Tet& tet, int32_t material)
{
    mesh.tets.push_back(tet);
    mesh.material.push_back(material);
}

inline void remove_tet(LabelledMesh& mesh, size_t t)
{
    mesh.tets.erase(mesh.tets.begin() + static_cast<std::ptrdiff_t>(t));
    mesh.material.erase(mesh.material.begin() + static_cast<std::ptrdiff_t>(t));
}

// A copy of an inner point, used by one tetrahedron only: a crack of width zero.
inline void repeat_point(LabelledMesh& mesh)
{
    int32_t& corner = mesh.tets[inner_tet(mesh)][0];
    mesh.points.push_back(mesh.points[corner]);
    corner = static_cast<int32_t>(mesh.points.size()) - 1;
}

// One tetrahedron split at the middle of an edge, but not those around that edge.
inline void make_t_junction(LabelledMesh& mesh)
{
    const size_t t = inner_tet(mesh);
    const Tet old = mesh.tets[t];
    const auto middle = static_cast<int32_t>(mesh.points.size());
    mesh.points.push_back((mesh.points[old[0]] + mesh.points[old[1]]) / 2);
    mesh.tets[t][1] = middle;
    add_tet(mesh, {middle, old[1], old[2], old[3]}, mesh.material[t]);
}

// An inner point pulled through the face opposite, and its tetrahedra turned to be positive again.
inline void fold(LabelledMesh& mesh)
{
    const Tet tet = mesh.tets[inner_tet(mesh)];
    const Vec3 x = mesh.points[tet[0]];
    const Vec3 opposite = (mesh.points[tet[1]] + mesh.points[tet[2]] + mesh.points[tet[3]]) / 3;
    mesh.points[tet[0]] = x + 1.5 * (opposite - x);
    for (Tet& t : mesh.tets)
        if (cleft::orient(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]) < 0)
            std::swap(t[2], t[3]);
}

// A third tetrahedron on an inner face.
inline void crowd_a_face(LabelledMesh& mesh)
{
    const Tet old = mesh.tets[inner_tet(mesh)];
    mesh.points.push_back(mesh.points[old[3]] + Vec3(0.01, 0.02, 0.01));
    add_tet(mesh, {old[0], old[1], old[2], static_cast<int32_t>(mesh.points.size()) - 1}, 0);
}

// A tetrahedron of no volume over the two triangles of a square of the hull.
inline void add_flat_tet(LabelledMesh& mesh)
{
    const auto lower_side = [&](int32_t p) { return mesh.points[p][2] == 0; };
    Tet flat{};
    size_t corners = 0;
    for (const Tet& t : mesh.tets)  // the two tetrahedra of a square come one after the other
        if (lower_side(t[1]) + lower_side(t[2]) + lower_side(t[3]) == 3 && corners < 4)
            for (size_t i = 1; i < 4; ++i)
                if (std::find(flat.begin(), flat.begin() + corners, t[i]) == flat.begin() + corners && corners < 4)
                    flat[corners++] = t[i];
    add_tet(mesh, flat, 0);
}

// A point of a side, not of an edge of the box.
inline int32_t side_point(const LabelledMesh& mesh)
{
    for (size_t p = 0; p < mesh.points.size(); ++p)
        if (mesh.points[p][2] == 0 && mesh.points[p][0] > 0.6 && mesh.points[p][1] > 0.6 && mesh.points[p][1] < 1.4)
            return static_cast<int32_t>(p);
    return -1;
}

// The same mesh with points, tetrahedra and (evenly) corners in another order.
inline LabelledMesh renumbered(const LabelledMesh& mesh, Random& random)
{
    const auto shuffled = [&](size_t count) {
        cleft::Array<int32_t> order(count);
        for (size_t i = 0; i < count; ++i) {
            order[i] = static_cast<int32_t>(i);
            std::swap(order[i], order[random.below(i + 1)]);
        }
        return order;
    };
    LabelledMesh out;
    out.points.resize(mesh.points.size());
    const cleft::Array<int32_t> number = shuffled(mesh.points.size());
    for (size_t p = 0; p < mesh.points.size(); ++p)
        out.points[number[p]] = mesh.points[p];
    for (const int32_t t : shuffled(mesh.tets.size())) {
        Tet tet = mesh.tets[t];
        std::rotate(tet.begin() + 1, tet.begin() + 1 + static_cast<std::ptrdiff_t>(random.below(3)), tet.end());
        if (random.below(2)) {
            std::swap(tet[0], tet[1]);
            std::swap(tet[2], tet[3]);
        }
        for (int32_t& p : tet)
            p = number[p];
        add_tet(out, tet, mesh.material[t]);
    }
    return out;
}

struct MeshCase {
    std::string name;
    LabelledMesh mesh;
    std::string fault;  // what the first fault must say; empty for a good mesh
};

inline cleft::Array<MeshCase> mesh_cases()
{
    cleft::Array<MeshCase> cases;
    for (const int materials : {1, 2, 5})
        cases.push_back({"good_" + std::to_string(materials), good_mesh(materials), ""});
    cases.push_back({"far_away", good_mesh(3), ""});
    for (Vec3& x : cases.back().mesh.points)
        x += Vec3(1000, -2000, 500);
    cases.push_back({"tiny", good_mesh(3, Vec3(3e-6, 2e-6, 1e-6)), ""});
    cases.push_back({"anisotropic", good_mesh(3, Vec3(3, 2, 9)), ""});

    // The break is given the good mesh and says what must be found.
    const auto broken = [&](const std::string& name, const std::string& fault, const auto& break_mesh) {
        LabelledMesh mesh = good_mesh(3);
        break_mesh(mesh);
        cases.push_back({name, mesh, fault});
    };
    broken("inverted", "is inverted", [](LabelledMesh& m) { std::swap(m.tets[40][0], m.tets[40][1]); });
    broken("inner_hole", "has nothing behind it", [](LabelledMesh& m) { remove_tet(m, inner_tet(m)); });
    broken("notch", "has nothing behind it", [](LabelledMesh& m) { remove_tet(m, m.tets.size() - 1); });
    broken("repeated_point", "is at the place of the", repeat_point);
    broken("t_junction", "has nothing behind it", make_t_junction);
    broken("folded", "on one side", fold);
    broken("crowded", "more than two tetrahedra", crowd_a_face);
    broken("flat", "is flat", add_flat_tet);
    broken("unused_point", "is in no tetrahedron", [](LabelledMesh& m) { m.points.push_back(Vec3(1, 1, 0.5)); });
    broken("dented", "has nothing behind it", [](LabelledMesh& m) { m.points[side_point(m)][2] += 0.01; });
    broken("wavy_side", "a volume of", [](LabelledMesh& m) { m.points[side_point(m)][2] += 1e-6; });
    broken("repeated_corner", "names a point twice", [](LabelledMesh& m) { m.tets[40][2] = m.tets[40][1]; });
    broken("several", "is at the place of the", [](LabelledMesh& m) {
        make_t_junction(m);
        remove_tet(m, 3);
        repeat_point(m);
        m.points.push_back(m.points[5]);
        m.points.push_back(m.points[6]);
    });
    return cases;
}

}  // namespace cleft_test
