// The nearest of many things in space: a tree of boxes.
#pragma once

#include "base/array.hpp"
#include "mesh/bounding_box.hpp"

#include <cstdint>

namespace cleft
{

// A complete binary tree over the boxes of items, halved along the longest side of their middles. Which items a node
// has follows from the boxes alone.
class NearestTree
{
public:
    explicit NearestTree(const Array<BoundingBox>& boxes);

    struct Nearest {
        int32_t item = -1;  // none
        double square = INFINITY;
    };
    // square_distance(item): of x, at least that of its box; infinite for an item that is not meant. Items beyond
    // `reach` are none.
    template <class SquareDistance>
    Nearest nearest(const Vec3& x, double reach, const SquareDistance& square_distance) const
    {
        Nearest best{-1, reach * reach};
        if (!items_.empty())
            descend(1, 0, items_.count(), x, square_distance, best);
        return best;
    }

private:
    // Looking at an item costs about as much as at a box.
    static constexpr int64_t kItemsOfLeaf = 4;

    void halve(int64_t node, int64_t begin, int64_t end, const Array<BoundingBox>& boxes);

    template <class SquareDistance>
    void descend(int64_t node, int64_t begin, int64_t end, const Vec3& x, const SquareDistance& square_distance,
                 Nearest& best) const
    {
        if (end - begin <= kItemsOfLeaf) {
            for (int64_t i = begin; i < end; ++i) {
                const double square = square_distance(items_[i]);
                // The lower number of equally near ones, whatever the order of the visits.
                if (square < best.square || (square == best.square && std::isfinite(square) && items_[i] < best.item))
                    best = {items_[i], square};
            }
            return;
        }
        const int64_t middle = begin + (end - begin) / 2;
        const double lower = boxes_[2 * node].square_distance(x), upper = boxes_[2 * node + 1].square_distance(x);
        const auto visit_lower = [&] {
            if (lower <= best.square)
                descend(2 * node, begin, middle, x, square_distance, best);
        };
        if (lower <= upper)
            visit_lower();
        if (upper <= best.square)
            descend(2 * node + 1, middle, end, x, square_distance, best);
        if (lower > upper)
            visit_lower();
    }

    Array<int32_t> items_;
    Array<BoundingBox> boxes_;  // by node, from 1: those below node n are 2n and 2n + 1
};

}  // namespace cleft
