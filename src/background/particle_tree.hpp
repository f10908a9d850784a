// A tree of boxes over the particles, eight to a leaf, to find what is near. The particles are put into the order of
// its leaves once; later, when they have moved a little, only the boxes are fitted again.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "base/vec.hpp"

#include <array>
#include <cstdint>

namespace cleft
{

// Eight floats fill a wide vector, and near_repulsion.cpp works on a leaf at a time.
constexpr int64_t kLeafSize = 8;
// Every so many leaves, counted from the first, fill a box of their own: a group.
constexpr int64_t kLeavesInGroup = 8;

// The order in which each run of eight points is a leaf: halves along the longest side, again and again.
Array<int32_t> tree_order(const Array<Vec3>& points, const Run& run);

struct ParticleTree {
    struct Node {
        Eigen::AlignedBox3d box;
        float reach = 0;    // of a leaf: the greatest of its particles
        int32_t leaf = -1;  // its number, or -1 for an inner node
        int32_t next = 0;   // the node that follows all below this one
    };
    Array<Node> nodes;      // a parent before its children
    Array<int32_t> leaves;  // the node of each leaf
};

// The shape for so many points. The boxes are empty until fit_boxes().
ParticleTree make_tree(int64_t points);

// `points` in tree order; a particle feels the others that are nearer than its reach.
void fit_boxes(ParticleTree& tree, const Array<Vec3>& points, const Array<float>& reach, const Run& run);

// visit(leaf) for every leaf whose box is nearer than `reach` to the box.
template <class Visit>
void for_leaves_near(const ParticleTree& tree, const Eigen::AlignedBox3d& box, double reach, const Visit& visit)
{
    const auto end = static_cast<int32_t>(tree.nodes.size());
    for (int32_t n = 0; n < end;) {
        const ParticleTree::Node& node = tree.nodes[n];
        CLEFT_ASSERT(node.next > n);
        const Vec3 gap = (node.box.min() - box.max()).cwiseMax(box.min() - node.box.max()).cwiseMax(0.0);
        if (gap.squaredNorm() >= reach * reach) {
            n = node.next;
            continue;
        }
        if (node.leaf >= 0)
            visit(node.leaf);
        ++n;
    }
}

}  // namespace cleft
