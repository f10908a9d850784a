// Finds for each triangle of a surface the tetrahedron and the face of it that the triangle is.
// Abaqus and CalculiX describe surfaces in this way.
#include "io/element_faces.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>

namespace cleft::io
{

namespace
{

using Corners = std::array<int32_t, 3>;

struct Triangle {
    Corners corners;  // ascending
    uint32_t group;
    int64_t index;
};

// The faces S1 to S4 of C3D4 in Abaqus's and CalculiX's manuals, counted from 0. The order is part
// of the format: loads are applied to a face by its number.
constexpr int kFaceCorners[4][3] = {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}};

Corners sorted(int32_t a, int32_t b, int32_t c)
{
    Corners corners{a, b, c};
    std::sort(corners.begin(), corners.end());
    return corners;
}

std::vector<Triangle> sorted_triangles(const MeshView& mesh)
{
    std::vector<Triangle> triangles;
    triangles.reserve(static_cast<size_t>(mesh.triangle_count()));
    for (size_t g = 0; g < mesh.groups.size(); ++g)
        for (int64_t t = 0; t < mesh.groups[g].count; ++t) {
            const int32_t* c = mesh.groups[g].triangles + 3 * t;
            triangles.push_back({sorted(c[0], c[1], c[2]), static_cast<uint32_t>(g), t});
        }
    std::sort(triangles.begin(), triangles.end(),
              [](const Triangle& a, const Triangle& b) { return a.corners < b.corners; });
    return triangles;
}

}  // namespace

std::vector<std::vector<ElementFace>> find_element_faces(const MeshView& mesh)
{
    const std::vector<Triangle> triangles = sorted_triangles(mesh);
    // Most tetrahedra lie inside. This test spares them the search, which is most of the time.
    std::vector<bool> on_surface(static_cast<size_t>(mesh.point_count), false);
    for (const Triangle& triangle : triangles)
        for (const int32_t p : triangle.corners)
            on_surface[static_cast<size_t>(p)] = true;

    std::vector<std::vector<ElementFace>> faces(mesh.groups.size());
    for (size_t g = 0; g < faces.size(); ++g)
        faces[g].resize(static_cast<size_t>(mesh.groups[g].count));
    for (int64_t t = 0; t < mesh.tet_count; ++t)
        for (int32_t f = 0; f < 4; ++f) {
            const int32_t* tet = mesh.tets + 4 * t;
            const auto& [i, j, k] = kFaceCorners[f];
            if (!on_surface[static_cast<size_t>(tet[i])] || !on_surface[static_cast<size_t>(tet[j])] ||
                !on_surface[static_cast<size_t>(tet[k])])
                continue;
            const Corners corners = sorted(tet[i], tet[j], tet[k]);
            const auto found = std::lower_bound(triangles.begin(), triangles.end(), corners,
                                                [](const Triangle& a, const Corners& b) { return a.corners < b; });
            if (found != triangles.end() && found->corners == corners &&
                // Of the two tetrahedra at an interface that of the first label is taken, so that
                // all faces of a surface look the same way.
                mesh.groups[found->group].first == mesh.tet_labels[t])
                faces[found->group][static_cast<size_t>(found->index)] = {t, f};
        }
    // Without this check the file would name face S0 of element 0, which no solver has.
    for (const std::vector<ElementFace>& group : faces)
        for (const ElementFace& face : group)
            if (face.tet < 0)
                throw Error(CLEFT_ERROR_INVALID_MESH, "a surface triangle is no face of a tetrahedron of its label");
    return faces;
}

}  // namespace cleft::io
