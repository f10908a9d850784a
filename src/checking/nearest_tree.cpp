// Halves the items until few are left.
#include "checking/nearest_tree.hpp"

#include <algorithm>
#include <numeric>

namespace cleft
{

NearestTree::NearestTree(const Array<BoundingBox>& boxes) : items_(boxes.size())
{
    std::iota(items_.begin(), items_.end(), 0);
    // The larger half of a node has (n + 1) / 2 items, so all leaves lie within so many levels.
    int64_t nodes = 1;
    for (int64_t most = items_.count(); most > kItemsOfLeaf; most = (most + 1) / 2)
        nodes *= 2;
    boxes_.resize(2 * nodes);
    halve(1, 0, items_.count(), boxes);
}

void NearestTree::halve(int64_t node, int64_t begin, int64_t end, const Array<BoundingBox>& boxes)
{
    const auto middle_of = [&](int32_t item) { return Vec3(boxes[item].lo + boxes[item].hi); };
    BoundingBox middles;
    BoundingBox& box = boxes_[node];
    for (int64_t i = begin; i < end; ++i) {
        middles.add(middle_of(items_[i]));
        box.add(boxes[items_[i]].lo);
        box.add(boxes[items_[i]].hi);
    }
    if (end - begin <= kItemsOfLeaf)
        return;
    int axis = 0;
    (middles.hi - middles.lo).maxCoeff(&axis);
    const int64_t half = begin + (end - begin) / 2;
    std::nth_element(items_.begin() + begin, items_.begin() + half, items_.begin() + end, [&](int32_t a, int32_t b) {
        const double at_a = middle_of(a)[axis], at_b = middle_of(b)[axis];
        return at_a != at_b ? at_a < at_b : a < b;
    });
    halve(2 * node, begin, half, boxes);
    halve(2 * node + 1, half, end, boxes);
}

}  // namespace cleft
