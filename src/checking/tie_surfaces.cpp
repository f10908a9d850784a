// Both surfaces are put in trees of boxes. The point of a volume's interface that is nearest to a place is found from
// the nearest of those that are known, about one a voxel.
#include "checking/tie_surfaces.hpp"

#include "volume/tie.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cleft
{

namespace
{

// Of the least spacing: a third material may lead by what so long a step changes, where a tie is still an interface.
constexpr double kHeldWithin = 0.05;

using Pair = std::array<Material, 2>;

// What stands for materials that are not met: of an interface each alone, of a line each two.
Array<Pair> parts_of(const TieMaterials& of)
{
    const auto& m = of.material;
    return of.is_line() ? Array<Pair>{{m[0], m[1]}, {m[0], m[2]}, {m[1], m[2]}}
                        : Array<Pair>{{m[0], m[0]}, {m[1], m[1]}};
}

// near(is_meant, reach) is the distance to the nearest interface or line whose materials are meant.
template <class Near>
double distance_to(const TieMaterials& of, double reach, const Near& near)
{
    const double own = near([&](const TieMaterials& m) { return m == of; }, reach);
    if (std::isfinite(own))
        return own;
    double greatest = 0;
    for (const Pair& part : parts_of(of)) {
        const auto is_meant = [&](const TieMaterials& m) {
            return m.is_line() == of.is_line() && m.has(part[0]) && m.has(part[1]);
        };
        greatest = std::max(greatest, near(is_meant, INFINITY));
    }
    return greatest;
}

Array<BoundingBox> boxes_of(const Array<TiePoint>& points)
{
    Array<BoundingBox> boxes;
    boxes.reserve(points.size());
    for (const TiePoint& point : points)
        boxes.push_back({point.x, point.x});
    return boxes;
}

Array<BoundingBox> boxes_of(const Array<TieElement>& elements, const Array<Vec3>& points)
{
    Array<BoundingBox> boxes(elements.size());
    for (size_t i = 0; i < elements.size(); ++i)
        for (const int32_t v : elements[i].corner)
            boxes[i].add(points[v]);
    return boxes;
}

}  // namespace

TieSurface::TieSurface(const Volume& volume, const Array<TiePoint>& points, const Placement& world)
    : volume_(volume), points_(points), world_(world), tree_(boxes_of(points))
{
}

double TieSurface::distance(const Vec3& x, const TieMaterials& of, Samples& scratch) const
{
    const double reach = kInterfaceReach * volume_.grid().spacing.maxCoeff();
    return distance_to(of, reach, [&](const auto& is_meant, double within) {
        const int32_t point = nearest(x, within, is_meant);
        return point < 0 ? INFINITY : distance_near(x, points_[point], scratch);
    });
}

// -1 if there is none.
template <class IsMeant>
int32_t TieSurface::nearest(const Vec3& x, double reach, const IsMeant& is_meant) const
{
    const auto square = [&](int32_t i) {
        return is_meant(points_[i].of) ? (points_[i].x - x).squaredNorm() : INFINITY;
    };
    return tree_.nearest(x, reach, square).item;
}

// The nearest known point is a voxel from the next one, so the tie near it is what tells the distance.
double TieSurface::distance_near(const Vec3& x, const TiePoint& known, Samples& scratch) const
{
    const double at_most = length(known.x - x);
    if (const auto on_tie = foot(x, known, scratch))
        return std::min(at_most, length(*on_tie - x));
    // The tie of two goes on where a third material holds: the interface has ended at a line.
    if (known.of.is_line())
        return at_most;
    const auto ends_it = [&](const TieMaterials& m) {
        return m.is_line() && m.has(known.of.material[0]) && m.has(known.of.material[1]);
    };
    const int32_t end = nearest(x, (known.x - x).norm(), ends_it);
    const auto on_line = end < 0 ? std::nullopt : foot(x, points_[end], scratch);
    return on_line ? std::min(at_most, length(*on_line - x)) : at_most;
}

// The point of the interface or line that is nearest to x.
std::optional<Vec3> TieSurface::foot(const Vec3& x, const TiePoint& known, Samples& scratch) const
{
    const MaterialSet set = known.of.set();
    const auto on_tie = nearest_on_tie(volume_, x, known.x, set, scratch);
    const double tolerance = kHeldWithin * volume_.grid().spacing.minCoeff();
    return on_tie && is_held_by(volume_, *on_tie, set, tolerance, scratch) ? on_tie : std::nullopt;
}

MeshSurface::MeshSurface(const Array<TieElement>& elements, const Array<Vec3>& points, double reach)
    : elements_(elements), points_(points), reach_(reach), tree_(boxes_of(elements, points))
{
}

double MeshSurface::distance(const Vec3& x, const TieMaterials& of) const
{
    return distance_to(of, reach_, [&](const auto& is_meant, double within) {
        const auto square = [&](int32_t i) {
            const auto& c = elements_[i].corner;
            return is_meant(elements_[i].of) ? square_distance(x, points_[c[0]], points_[c[1]], points_[c[2]])
                                             : INFINITY;
        };
        const NearestTree::Nearest found = tree_.nearest(x, within, square);
        return found.item < 0 ? INFINITY : std::sqrt(found.square);
    });
}

}  // namespace cleft
