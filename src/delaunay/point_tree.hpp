// The points of a Delaunay mesh, halved in space down to bricks, and along a curve down to a few.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "delaunay/perturbed.hpp"
#include "mesh/bounding_box.hpp"

#include <cstdint>

namespace cleft
{

// A complete binary tree, of levels whose nodes have the same number of points but for one. All of it follows from the
// points and their number.
//   Nodes are numbered from 1, level by level: those below node n are 2n and 2n + 1.
class PointTree
{
public:
    struct Point {
        Vec3 x;
        int32_t number;  // in the array of the caller
    };
    struct Range {
        int64_t begin, end;
        int64_t count() const { return end - begin; }
    };

    // Bricks have at most `points_in_brick` points, and at least half as many.
    PointTree(const Array<Vec3>& points, int64_t points_in_brick, const Run& run);

    // The points of a brick follow one another, along a Hilbert curve.
    const Array<Point>& points() const { return points_; }
    NumberedPoint numbered(int64_t position) const { return {&points_[position].x, points_[position].number}; }
    int64_t brick_count() const { return int64_t{1} << brick_level_; }
    int64_t brick_node(int64_t brick) const { return brick_count() + brick; }
    bool is_leaf(int64_t node) const { return node >> leaf_level_ != 0; }
    Range range(int64_t node) const;
    const BoundingBox& box(int64_t node) const { return boxes_[node]; }

private:
    void halve(int64_t node);
    void order_brick(int64_t brick, const Run& run);

    Array<Point> points_;
    Array<BoundingBox> boxes_;
    int brick_level_ = 0, leaf_level_ = 0;
};

}  // namespace cleft
