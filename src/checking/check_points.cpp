// Finds the points that are not finite, in no tetrahedron, or at the place of another, and the box of the others.
#include "checking/check_points.hpp"

#include "mesh/face_buckets.hpp"

#include <cmath>

namespace cleft
{

namespace
{

// Points of one place get the same cell, whatever the spread of the mesh. Two points nearer than a cell may still lie
// on either side of its border, and then pass.
constexpr double kCells = 1e9;  // along the longest side: points of one cell are at the same place

struct PlaceInBox {
    uint64_t xy;
    uint32_t z;
    int32_t point;

    bool same(const PlaceInBox& o) const { return xy == o.xy && z == o.z; }
    // Places first, then numbers: so the first repeated point is the same in every run.
    bool operator<(const PlaceInBox& o) const { return xy != o.xy ? xy < o.xy : z != o.z ? z < o.z : point < o.point; }
};

PlaceInBox place_in_box(const Array<Vec3>& points, size_t p, const BoundingBox& box)
{
    // Halves, because the difference of two finite numbers may overflow.
    const double longest = (box.hi / 2 - box.lo / 2).maxCoeff();
    FixedArray<uint32_t, 3> cell{};
    for (int axis = 0; axis < 3; ++axis)
        if (longest > 0)
            cell[axis] =
                static_cast<uint32_t>(std::nearbyint((points[p][axis] / 2 - box.lo[axis] / 2) / longest * kCells));
    return {uint64_t{cell[0]} << 32 | cell[1], cell[2], static_cast<int32_t>(p)};
}

void check_repeated(const Array<Vec3>& points, const Array<char>& used, PointChecks& out)
{
    Array<PlaceInBox> places;
    places.reserve(points.size());
    for (size_t p = 0; p < points.size(); ++p)
        if (used[p] && points[p].allFinite())
            places.push_back(place_in_box(points, p, out.box));
    std::sort(places.begin(), places.end());
    for (size_t i = 1; i < places.size(); ++i)
        if (places[i].same(places[i - 1])) {
            if (out.repeated.count == 0)
                out.repeated_of = places[i - 1].point;
            out.repeated.add(places[i].point);
        }
}

}  // namespace

PointChecks check_points(const RegionMesh& mesh)
{
    const auto point_count = mesh.points.count();
    Array<char> used(mesh.points.size(), 0);
    for (const Tet& tet : mesh.tets)
        if (!has_bad_index(tet, point_count))
            for (const int32_t p : tet)
                used[p] = 1;

    PointChecks out;
    for (size_t p = 0; p < mesh.points.size(); ++p) {
        const bool finite = mesh.points[p].allFinite();
        if (!finite)
            out.non_finite.add(static_cast<int64_t>(p));
        if (!used[p])
            out.unused.add(static_cast<int64_t>(p));
        // A point that no tetrahedron has would enlarge the box, and every hull face would seem to lie off its sides.
        if (finite && used[p])
            out.box.add(mesh.points[p]);
    }
    check_repeated(mesh.points, used, out);
    return out;
}

}  // namespace cleft
