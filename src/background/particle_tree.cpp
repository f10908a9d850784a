// Builds the tree over the particles, whose shape depends on their number alone, and fits its boxes.
#include "background/particle_tree.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <numeric>

namespace cleft
{

namespace
{

// Where a run of particles is cut in two: a whole number of groups on the left, or of leaves inside a group.
int64_t left_part(int64_t count)
{
    constexpr int64_t kGroupSize = kLeafSize * kLeavesInGroup;
    const int64_t unit = count > kGroupSize ? kGroupSize : kLeafSize;
    const int64_t units = (count + unit - 1) / unit;
    return (units + 1) / 2 * unit;
}

struct Range {
    int64_t begin, end;
};

void cut(const Array<Vec3>& points, Array<int32_t>& order, const Range& range)
{
    Eigen::AlignedBox3d box;
    for (int64_t i = range.begin; i < range.end; ++i)
        box.extend(points[order[i]]);
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const auto first = order.begin() + range.begin;
    std::nth_element(first, first + left_part(range.end - range.begin), order.begin() + range.end,
                     [&](int32_t a, int32_t b) {
                         const double xa = points[a][axis], xb = points[b][axis];
                         // Equal coordinates, as in a wall or a lattice, are ordered by number. Otherwise the halves
                         // would depend on the library's algorithm.
                         return xa != xb ? xa < xb : a < b;
                     });
}

int32_t add_node(ParticleTree& tree, int64_t points)
{
    const auto self = static_cast<int32_t>(tree.nodes.size());
    tree.nodes.emplace_back();
    if (points <= kLeafSize) {
        tree.nodes.back().leaf = static_cast<int32_t>(tree.leaves.size());
        tree.leaves.push_back(self);
    } else {
        add_node(tree, left_part(points));
        add_node(tree, points - left_part(points));
    }
    tree.nodes[self].next = static_cast<int32_t>(tree.nodes.size());
    return self;
}

}  // namespace

Array<int32_t> tree_order(const Array<Vec3>& points, const Run& run)
{
    Array<int32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    Array<Range> level{{0, points.count()}};
    while (!level.empty()) {
        Array<Range> next;
        for (const Range& r : level)
            if (r.end - r.begin > kLeafSize) {
                const int64_t middle = r.begin + left_part(r.end - r.begin);
                next.push_back({r.begin, middle});
                next.push_back({middle, r.end});
            }
        // Ranges of a level do not overlap, so that threads can cut them at the same time.
        const int64_t grain = std::max<int64_t>(1, level.count() / 256);
        parallel_for(run, level.count(), grain, [&](int64_t begin, int64_t end) {
            for (int64_t i = begin; i < end; ++i)
                if (level[i].end - level[i].begin > kLeafSize)
                    cut(points, order, level[i]);
        });
        level = std::move(next);
    }
    return order;
}

ParticleTree make_tree(int64_t points)
{
    ParticleTree tree;
    const int64_t leaves = points / kLeafSize + 1;
    tree.leaves.reserve(leaves);
    tree.nodes.reserve(2 * leaves);
    add_node(tree, points);
    return tree;
}

void fit_boxes(ParticleTree& tree, const Array<Vec3>& points, const Array<float>& reach, const Run& run)
{
    CLEFT_ASSERT(points.size() == reach.size());
    parallel_for(run, tree.leaves.count(), 1024, [&](int64_t begin, int64_t end) {
        for (int64_t leaf = begin; leaf < end; ++leaf) {
            ParticleTree::Node& node = tree.nodes[tree.leaves[leaf]];
            node.box.setEmpty();
            node.reach = 0;
            const int64_t last = std::min((leaf + 1) * kLeafSize, points.count());
            for (int64_t i = leaf * kLeafSize; i < last; ++i) {
                node.box.extend(points[i]);
                node.reach = std::max(node.reach, reach[i]);
            }
        }
    });
    // Backwards, since a parent comes before its children.
    for (int64_t n = tree.nodes.count(); n-- > 0;) {
        ParticleTree::Node& node = tree.nodes[n];
        if (node.leaf >= 0)
            continue;
        const ParticleTree::Node& left = tree.nodes[n + 1];
        const ParticleTree::Node& right = tree.nodes[left.next];
        node.box = left.box.merged(right.box);
    }
}

}  // namespace cleft
