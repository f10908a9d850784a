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

void cut(const std::vector<Vec3>& points, std::vector<int32_t>& order, const Range& range)
{
    Eigen::AlignedBox3d box;
    for (int64_t i = range.begin; i < range.end; ++i)
        box.extend(points[static_cast<size_t>(order[static_cast<size_t>(i)])]);
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const auto first = order.begin() + range.begin;
    std::nth_element(
        first, first + left_part(range.end - range.begin), order.begin() + range.end, [&](int32_t a, int32_t b) {
            const double xa = points[static_cast<size_t>(a)][axis], xb = points[static_cast<size_t>(b)][axis];
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
    tree.nodes[static_cast<size_t>(self)].next = static_cast<int32_t>(tree.nodes.size());
    return self;
}

}  // namespace

std::vector<int32_t> tree_order(const std::vector<Vec3>& points, const Run& run)
{
    std::vector<int32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<Range> level{{0, static_cast<int64_t>(points.size())}};
    while (!level.empty()) {
        std::vector<Range> next;
        for (const Range& r : level)
            if (r.end - r.begin > kLeafSize) {
                const int64_t middle = r.begin + left_part(r.end - r.begin);
                next.push_back({r.begin, middle});
                next.push_back({middle, r.end});
            }
        const int64_t grain = std::max<int64_t>(1, static_cast<int64_t>(level.size()) / 256);
        parallel_for(run, static_cast<int64_t>(level.size()), grain, [&](int64_t begin, int64_t end) {
            for (int64_t i = begin; i < end; ++i)
                if (level[static_cast<size_t>(i)].end - level[static_cast<size_t>(i)].begin > kLeafSize)
                    cut(points, order, level[static_cast<size_t>(i)]);
        });
        level = std::move(next);
    }
    return order;
}

ParticleTree make_tree(size_t points)
{
    ParticleTree tree;
    const size_t leaves = points / static_cast<size_t>(kLeafSize) + 1;
    tree.leaves.reserve(leaves);
    tree.nodes.reserve(2 * leaves);
    add_node(tree, static_cast<int64_t>(points));
    return tree;
}

void fit_boxes(ParticleTree& tree, const std::vector<Vec3>& points, const std::vector<float>& reach, const Run& run)
{
    parallel_for(run, static_cast<int64_t>(tree.leaves.size()), 1024, [&](int64_t begin, int64_t end) {
        for (int64_t leaf = begin; leaf < end; ++leaf) {
            ParticleTree::Node& node = tree.nodes[static_cast<size_t>(tree.leaves[static_cast<size_t>(leaf)])];
            node.box.setEmpty();
            node.reach = 0;
            const auto last = std::min(static_cast<size_t>((leaf + 1) * kLeafSize), points.size());
            for (auto i = static_cast<size_t>(leaf * kLeafSize); i < last; ++i) {
                node.box.extend(points[i]);
                node.reach = std::max(node.reach, reach[i]);
            }
        }
    });
    for (size_t n = tree.nodes.size(); n-- > 0;) {
        ParticleTree::Node& node = tree.nodes[n];
        if (node.leaf >= 0)
            continue;
        const ParticleTree::Node& left = tree.nodes[n + 1];
        const ParticleTree::Node& right = tree.nodes[static_cast<size_t>(left.next)];
        node.box = left.box.merged(right.box);
    }
}

}  // namespace cleft
