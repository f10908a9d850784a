// Depth-first search in the tree of points, nearer halves first.
#include "delaunay/intruder.hpp"

#include "mesh/predicates.hpp"

#include <algorithm>
#include <array>
#include <cfloat>

namespace cleft
{

namespace
{

// The nearest point to `target.from` within `target.square` for which target.has() holds. target.may_have() is false of
// boxes without such points.
template <class Target>
int64_t nearest_of(const PointTree& tree, int64_t left_out, Target& target)
{
    std::array<int64_t, 130> waiting{};  // two for each level at most
    size_t count = 0;
    waiting[count++] = 1;
    int64_t found = -1;
    while (count > 0) {
        const int64_t node = waiting[--count];
        const BoundingBox& box = tree.box(node);
        if (node == left_out || box.square_distance(target.from) > target.square || !target.may_have(box))
            continue;
        if (!tree.is_leaf(node)) {
            const bool second_is_nearer =
                tree.box(2 * node + 1).square_distance(target.from) < tree.box(2 * node).square_distance(target.from);
            waiting[count++] = 2 * node + (second_is_nearer ? 0 : 1);
            waiting[count++] = 2 * node + (second_is_nearer ? 1 : 0);
            continue;
        }
        const PointTree::Range range = tree.range(node);
        for (int64_t i = range.begin; i < range.end; ++i) {
            const double square = (tree.points()[i].x - target.from).squaredNorm();
            if (square <= target.square && target.has(tree.numbered(i), square)) {
                target.square = square;
                found = i;
            }
        }
    }
    return found;
}

struct Sphere {
    const DelaunayKernel& kernel;
    const Cell& cell;
    Vec3 from;
    double square, inner;

    static bool may_have(const BoundingBox&) { return true; }
    bool has(const NumberedPoint& point, double at) const
    {
        for (const int32_t corner : cell.corners)
            if (kernel.number(corner) == point.number)
                return false;
        return at < inner || kernel.has_inside(cell, point);
    }
};

struct BeyondFace {
    const Vec3 &from, &b, &c;
    double square = std::numeric_limits<double>::infinity();
    Vec3 least_normal, greatest_normal;

    BeyondFace(const Vec3& first, const Vec3& second, const Vec3& third) : from(first), b(second), c(third)
    {
        const Vec3 u = b - from, v = c - from;
        const Vec3 normal = u.cross(v);
        // A component is exactly zero where the face lies along that axis, and so has no error.
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            const double error = 4 * DBL_EPSILON * (std::abs(u[j] * v[k]) + std::abs(u[k] * v[j]));
            least_normal[i] = normal[i] - error;
            greatest_normal[i] = normal[i] + error;
        }
    }

    // Is any corner of the box beyond the plane, with whatever normal it may have?
    bool may_have(const BoundingBox& box) const
    {
        double sum = 0, magnitude = 0;
        for (int i = 0; i < 3; ++i) {
            const double lo = box.lo[i] - from[i], hi = box.hi[i] - from[i];
            const double most = std::max(
                {lo * least_normal[i], lo * greatest_normal[i], hi * least_normal[i], hi * greatest_normal[i]});
            sum += most;
            magnitude += std::abs(most);
        }
        return sum + 8 * DBL_EPSILON * magnitude > 0;
    }
    bool has(const NumberedPoint& point, double) const { return orient_sign(from, b, c, *point.x) > 0; }
};

}  // namespace

int64_t find_intruder(const PointTree& tree, int64_t brick, const DelaunayKernel& kernel, const Cell& cell)
{
    const int64_t own = tree.brick_node(brick);
    if (cell.is_ghost()) {
        BeyondFace face(kernel.place(cell.corners[0]), kernel.place(cell.corners[1]), kernel.place(cell.corners[2]));
        return nearest_of(tree, own, face);
    }
    Vec3 centre = kernel.origin();
    for (int i = 0; i < 3; ++i)
        centre[i] += static_cast<double>(cell.centre[i]);
    Sphere sphere{kernel, cell, centre, static_cast<double>(cell.outer), static_cast<double>(cell.inner)};
    return nearest_of(tree, own, sphere);
}

}  // namespace cleft
