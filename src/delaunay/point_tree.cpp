// Builds the tree: the bricks level by level, and then each brick by itself.
#include "delaunay/point_tree.hpp"

#include "base/parallel.hpp"
#include "mesh/curve_order.hpp"

#include <algorithm>
#include <numeric>

namespace cleft
{

namespace
{

// Points that a query looks at one by one. Fewer make the tree deeper and larger, more make queries slower.
constexpr int64_t kPointsInLeaf = 8;

int level_of_node(int64_t node)
{
    int level = 0;
    while (node >> (level + 1))
        ++level;
    return level;
}

int longest_axis(const BoundingBox& box)
{
    Eigen::Index axis = 0;
    (box.hi - box.lo).maxCoeff(&axis);
    return static_cast<int>(axis);
}

}  // namespace

PointTree::Range PointTree::range(int64_t node) const
{
    const int level = level_of_node(node);
    const int64_t index = node - (int64_t{1} << level);
    return {(index * points_.count()) >> level, ((index + 1) * points_.count()) >> level};
}

PointTree::PointTree(const Array<Vec3>& points, int64_t points_in_brick, const Run& run)
{
    const auto levels_to = [&](int64_t most) {
        int level = 0;
        while ((points.count() - 1) >> level >= most)
            ++level;
        return level;
    };
    brick_level_ = levels_to(points_in_brick);
    leaf_level_ = std::max(brick_level_, levels_to(kPointsInLeaf));
    points_.resize(points.size());
    boxes_.resize(int64_t{2} << leaf_level_);
    parallel_for(run, points.count(), 1 << 15, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i)
            points_[i] = {points[i], static_cast<int32_t>(i)};
    });
    for (int level = 0; level < brick_level_; ++level)
        parallel_for(run, int64_t{1} << level, 1, [&](int64_t begin, int64_t end) {
            for (int64_t index = begin; index < end; ++index)
                halve((int64_t{1} << level) + index);
        });
    Run alone;
    alone.cancel = run.cancel;
    parallel_for(run, brick_count(), 1, [&](int64_t begin, int64_t end) {
        for (int64_t brick = begin; brick < end; ++brick)
            order_brick(brick, alone);
    });
    for (int64_t node = brick_count() - 1; node > 0; --node) {
        boxes_[node] = boxes_[2 * node];
        boxes_[node].add(boxes_[2 * node + 1].lo);
        boxes_[node].add(boxes_[2 * node + 1].hi);
    }
}

void PointTree::halve(int64_t node)
{
    const auto [begin, end] = range(node);
    const int64_t middle = range(2 * node).end;
    BoundingBox box;
    for (int64_t i = begin; i < end; ++i)
        box.add(points_[i].x);
    const int axis = longest_axis(box);
    std::nth_element(points_.begin() + begin, points_.begin() + middle, points_.begin() + end,
                     [&](const Point& a, const Point& b) { return a.x[axis] < b.x[axis]; });
}

void PointTree::order_brick(int64_t brick, const Run& run)
{
    const auto [begin, end] = range(brick_node(brick));
    Array<Vec3> places(end - begin);
    for (int64_t i = begin; i < end; ++i)
        places[i - begin] = points_[i].x;
    Array<int32_t> order(places.size());
    std::iota(order.begin(), order.end(), 0);
    order_along_curve(places, order, run);
    const Array<Point> unordered(points_.begin() + begin, points_.begin() + end);
    for (int64_t i = begin; i < end; ++i)
        points_[i] = unordered[order[i - begin]];
    for (int level = leaf_level_; level >= brick_level_; --level) {
        const int64_t first = brick_node(brick) << (level - brick_level_);
        for (int64_t node = first; node < first + (int64_t{1} << (level - brick_level_)); ++node) {
            BoundingBox& box = boxes_[node];
            if (level == leaf_level_) {
                const Range range = this->range(node);
                for (int64_t i = range.begin; i < range.end; ++i)
                    box.add(points_[i].x);
            } else {
                box = boxes_[2 * node];
                box.add(boxes_[2 * node + 1].lo);
                box.add(boxes_[2 * node + 1].hi);
            }
        }
    }
}

}  // namespace cleft
