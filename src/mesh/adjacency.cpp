// Finds the neighbours of tetrahedra over their faces, and the axes along which points of the hull must not move.
#include "mesh/adjacency.hpp"

#include "base/error.hpp"
#include "base/ordinal.hpp"
#include "base/parallel.hpp"
#include "mesh/face_buckets.hpp"

namespace cleft
{

namespace
{

[[noreturn]] void refuse_crowded_face(const HalfFace* faces, size_t count)
{
    throw Error(CLEFT_ERROR_INVALID_MESH, std::to_string(count) + " tetrahedra share one face: the " +
                                              ordinal(faces[0].tet()) + ", the " + ordinal(faces[1].tet()) + ", the " +
                                              ordinal(faces[2].tet()) + (count > 3 ? ", ..." : ""));
}

}  // namespace

Array<FixedArray<int32_t, 4>> tet_neighbours(const Array<Tet>& tets, int64_t point_count, const Run& run)
{
    for (size_t t = 0; t < tets.size(); ++t)
        // FaceBuckets passes over tetrahedra with a bad index. Their neighbours would be -1, as on the hull, so they
        // are refused.
        if (has_bad_index(tets[t], point_count) || has_repeated_corner(tets[t]))
            throw Error(CLEFT_ERROR_INVALID_MESH, "the " + ordinal(static_cast<int64_t>(t)) +
                                                      " tetrahedron does not have four different points of the mesh");
    const FaceBuckets buckets(tets, point_count, run);
    Array<FixedArray<int32_t, 4>> neighbours(tets.size(), {-1, -1, -1, -1});
    const auto link = [&](const HalfFace& from, const HalfFace& to) {
        neighbours[from.tet()][from.corner()] = to.tet();
    };
    // Each face is visited once, by the thread that has its least point. So no two threads write the same entry.
    parallel_for(run, point_count, FaceBuckets::kPointsAtOnce, [&](int64_t begin, int64_t end) {
        buckets.for_each_face(begin, end, [&](const HalfFace* faces, size_t count) {
            if (count > 2)
                refuse_crowded_face(faces, count);
            if (count == 2) {
                link(faces[0], faces[1]);
                link(faces[1], faces[0]);
            }
        });
    });
    return neighbours;
}

Array<uint8_t> frozen_axes(const Array<Vec3>& points, const Array<Tet>& tets,
                           const Array<FixedArray<int32_t, 4>>& neighbours)
{
    Array<uint8_t> frozen(points.size(), 0);
    for (size_t t = 0; t < tets.size(); ++t)
        for (size_t i = 0; i < 4; ++i) {
            if (neighbours[t][i] >= 0)
                continue;
            const int* corner = kFaceCorners[i];
            const FixedArray<int32_t, 3> face{tets[t][corner[0]], tets[t][corner[1]], tets[t][corner[2]]};
            // An exact comparison finds the sides of the box, since they are planes across an axis in the local frame
            // (decision 1).
            const unsigned axes = hull_axes(points[face[0]], points[face[1]], points[face[2]]);
            for (const int32_t p : face)
                frozen[p] = static_cast<uint8_t>(frozen[p] | axes);
        }
    return frozen;
}

unsigned hull_axes(const Vec3& a, const Vec3& b, const Vec3& c)
{
    unsigned axes = 0;
    for (int axis = 0; axis < 3; ++axis)
        if (a[axis] == b[axis] && a[axis] == c[axis])
            axes |= 1u << axis;
    // A face in no such plane is part of a hull of any shape, which only points that stay can keep.
    return axes ? axes : 7u;
}

}  // namespace cleft
