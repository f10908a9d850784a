// Finds the faces that only one tetrahedron of those shown has.
//
// The three faces of a tetrahedron at its least corner, and the face opposite to it, are looked for at the least corner
// of the face: each tetrahedron is listed at its least corner and at the one that follows. That takes 8 bytes a
// tetrahedron, where a list of all faces would take 64.
#include "io/render/outer_faces.hpp"

#include "base/collect.hpp"
#include "base/counting_sort.hpp"
#include "base/fixed_array.hpp"

#include <algorithm>

namespace cleft::io
{

namespace
{

using SortedCorners = FixedArray<int32_t, 4>;

SortedCorners sorted_corners(const MeshView& mesh, int64_t tet)
{
    SortedCorners corners;
    std::copy_n(mesh.tets + 4 * tet, 4, corners.begin());
    std::sort(corners.begin(), corners.end());
    return corners;
}

bool is_before(const OuterFace& a, const OuterFace& b)
{
    if (a.corners[1] != b.corners[1])
        return a.corners[1] < b.corners[1];
    return a.corners[2] != b.corners[2] ? a.corners[2] < b.corners[2] : a.tet < b.tet;
}

bool is_same_face(const OuterFace& a, const OuterFace& b)
{
    return a.corners[1] == b.corners[1] && a.corners[2] == b.corners[2];
}

// The faces of a tetrahedron whose least corner is `point`.
void add_faces_at(int32_t point, const SortedCorners& c, int32_t tet, Array<OuterFace>& faces)
{
    if (c[0] == point) {
        faces.push_back({{c[0], c[1], c[2]}, c[3], tet});
        faces.push_back({{c[0], c[1], c[3]}, c[2], tet});
        faces.push_back({{c[0], c[2], c[3]}, c[1], tet});
    }
    if (c[1] == point)
        faces.push_back({{c[1], c[2], c[3]}, c[0], tet});
}

// Adds those that have no partner.
void add_single(Array<OuterFace>& faces, Array<OuterFace>& single)
{
    std::sort(faces.begin(), faces.end(), is_before);
    for (int64_t i = 0; i < faces.count();) {
        int64_t next = i + 1;
        while (next < faces.count() && is_same_face(faces[i], faces[next]))
            ++next;
        if (next - i != 2)
            single.push_back(faces[i]);
        i = next;
    }
}

}  // namespace

Array<OuterFace> outer_faces(const MeshView& mesh, const Array<char>& is_shown, const Run& run)
{
    constexpr int64_t kPoints = 1 << 12;  // a chunk, of some ten thousand tetrahedra
    CountingSort<int64_t, int32_t> sort;
    const auto at_points = sort.sort(run, mesh.tet_count, mesh.point_count, [&](int64_t tet, const auto& give) {
        if (!is_shown[tet])
            return;
        const SortedCorners corners = sorted_corners(mesh, tet);
        give(corners[0], static_cast<int32_t>(tet));
        // A point that is twice a corner, in a broken mesh, has the tetrahedron once.
        if (corners[1] != corners[0])
            give(corners[1], static_cast<int32_t>(tet));
    });
    return collect<OuterFace>(run, mesh.point_count, kPoints, [&](int64_t begin, int64_t end, Array<OuterFace>& list) {
        Array<OuterFace> faces;
        for (int64_t point = begin; point < end; ++point) {
            faces.clear();
            for (int64_t i = at_points.start[point]; i < at_points.start[point + 1]; ++i)
                add_faces_at(static_cast<int32_t>(point), sorted_corners(mesh, at_points.values[i]),
                             at_points.values[i], faces);
            add_single(faces, list);
        }
    });
}

}  // namespace cleft::io
