// Points that two pieces share are found by their coordinates, which no work on either piece changes.
#include "mesh/piece.hpp"

#include "mesh/interfaces.hpp"
#include "mesh/surface_points.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace cleft
{

namespace
{

// The points of some tetrahedra, and these tetrahedra under the new numbers of their points.
void take_points(const Array<Vec3>& all, Array<Vec3>& points, Array<Tet>& tets)
{
    Array<int32_t> number(all.size(), -1);
    for (const Tet& tet : tets)
        for (const int32_t p : tet)
            number[p] = 0;
    for (int64_t p = 0; p < all.count(); ++p)
        if (number[p] == 0) {
            number[p] = static_cast<int32_t>(points.size());
            points.push_back(all[p]);
        }
    for (Tet& tet : tets)
        for (int32_t& p : tet)
            p = number[p];
}

Array<int32_t> hull_points(const LabelledMesh& mesh, const Run& run)
{
    const Array<uint8_t> inside = points_inside(mesh.tets, mesh.points.size(), run);
    Array<int32_t> hull;
    for (int32_t p = 0; p < mesh.points.count(); ++p)
        if (!inside[p])
            hull.push_back(p);
    return hull;
}

// Some points by their places.
class Places
{
public:
    Places(const Array<Vec3>& points, const Array<int32_t>& some) : points_(points), sorted_(some.begin(), some.end())
    {
        std::sort(sorted_.begin(), sorted_.end(),
                  [&](int32_t p, int32_t q) { return is_lower_place(points_[p], points_[q]); });
    }
    // The point at a place; -1 if there is none.
    int32_t find(const Vec3& x) const
    {
        const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), x, [&](int32_t p, const Vec3& wanted) {
            return is_lower_place(points_[p], wanted);
        });
        return found != sorted_.end() && points_[*found] == x ? *found : -1;
    }

private:
    const Array<Vec3>& points_;
    Array<int32_t> sorted_;
};

}  // namespace

LabelledMesh piece_of(const LabelledMesh& mesh, const std::function<bool(int64_t tet)>& is_in)
{
    LabelledMesh piece;
    for (int64_t t = 0; t < mesh.tets.count(); ++t)
        if (is_in(t)) {
            piece.tets.push_back(mesh.tets[t]);
            piece.material.push_back(mesh.material[t]);
        }
    take_points(mesh.points, piece.points, piece.tets);
    return piece;
}

TetMesh piece_of(const TetMesh& mesh, const std::function<bool(int64_t tet)>& is_in)
{
    TetMesh piece;
    for (int64_t t = 0; t < mesh.tets.count(); ++t)
        if (is_in(t))
            piece.tets.push_back(mesh.tets[t]);
    take_points(mesh.points, piece.points, piece.tets);
    return piece;
}

bool is_lower_place(const Vec3& x, const Vec3& y)
{
    return x[2] != y[2] ? x[2] < y[2] : x[1] != y[1] ? x[1] < y[1] : x[0] < y[0];
}

TetMesh ordered_by_place(const TetMesh& mesh)
{
    Array<int32_t> order(mesh.points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](int32_t p, int32_t q) { return is_lower_place(mesh.points[p], mesh.points[q]); });
    Array<int32_t> number(mesh.points.size());
    TetMesh out;
    out.points.reserve(mesh.points.size());
    for (const int32_t p : order) {
        number[p] = static_cast<int32_t>(out.points.size());
        out.points.push_back(mesh.points[p]);
    }
    out.tets.reserve(mesh.tets.size());
    for (Tet tet : mesh.tets) {
        for (int32_t& p : tet)
            p = number[p];
        out.tets.push_back(tet);
    }
    std::sort(out.tets.begin(), out.tets.end());
    return out;
}

Array<Vec3> places_of(const Array<Vec3>& points, const Array<int32_t>& some)
{
    Array<Vec3> places;
    places.reserve(some.size());
    for (const int32_t p : some)
        places.push_back(points[p]);
    return places;
}

Array<int32_t> points_at(const Array<Vec3>& points, const Array<int32_t>& candidates, const Array<Vec3>& places)
{
    Array<Vec3> sorted(places.begin(), places.end());
    std::sort(sorted.begin(), sorted.end(), is_lower_place);
    Array<int32_t> found;
    std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(found), [&](int32_t p) {
        return std::binary_search(sorted.begin(), sorted.end(), points[p], is_lower_place);
    });
    return found;
}

Array<uint8_t> near_points(const Array<Tet>& tets, size_t point_count, const Array<int32_t>& points, int rings)
{
    Array<uint8_t> has_point(point_count, 0), is_near(tets.size(), 0);
    for (const int32_t p : points)
        has_point[p] = 1;
    for (int ring = 0; ring < rings; ++ring) {
        for (int64_t t = 0; t < tets.count(); ++t)
            is_near[t] =
                is_near[t] || std::any_of(tets[t].begin(), tets[t].end(), [&](int32_t p) { return has_point[p] != 0; });
        for (int64_t t = 0; t < tets.count(); ++t)
            if (is_near[t])
                for (const int32_t p : tets[t])
                    has_point[p] = 1;
    }
    return is_near;
}

LabelledMesh joined(LabelledMesh a, const LabelledMesh& b, const Run& run)
{
    const Array<int32_t> hull = hull_points(a, run);
    Array<int32_t> number(b.points.size(), -1);
    {
        const Places places(a.points, hull);
        for (const int32_t p : hull_points(b, run))
            number[p] = places.find(b.points[p]);
    }
    for (int64_t p = 0; p < b.points.count(); ++p)
        if (number[p] < 0) {
            number[p] = static_cast<int32_t>(a.points.size());
            a.points.push_back(b.points[p]);
        }
    for (int64_t t = 0; t < b.tets.count(); ++t) {
        Tet tet = b.tets[t];
        for (int32_t& p : tet)
            p = number[p];
        a.tets.push_back(tet);
        a.material.push_back(b.material[t]);
    }
    return a;
}

Array<int32_t> points_of_cut(const RegionMesh& piece, const BoundingBox& box, const Run& run)
{
    const Interfaces surface = extract_interfaces(piece, box.lo, box.hi, run);
    Array<int32_t> points;
    for (int64_t i = 0; i < surface.hull.count(); ++i)
        if (surface.hull_side[i] == Side::other)
            points.insert(points.end(), surface.hull[i].begin(), surface.hull[i].end());
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

Array<int32_t> points_of_cut(const TetMesh& piece, const BoundingBox& box, const Run& run)
{
    const Array<int32_t> one_region(piece.tets.size(), 0);
    return points_of_cut({piece.points, piece.tets, one_region}, box, run);
}

}  // namespace cleft
