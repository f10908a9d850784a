// Finds, for each group of leaves, the particles and images that it can feel, and for each leaf those of the group.
#include "background/near_lists.hpp"

#include "base/parallel.hpp"
#include "base/wide_vectors.hpp"

#include <cmath>

namespace cleft
{

namespace
{

const ParticleTree::Node& node_of(const ParticleTree& tree, int32_t leaf) { return tree.nodes[tree.leaves[leaf]]; }

// The box of the leaves of a group, and how far its particles reach.
struct Region {
    Eigen::AlignedBox3d box;
    double reach = 0;
};

Region region_of(const ParticleTree& tree, const NearGroup& group)
{
    Region region;
    for (int32_t leaf = group.first_leaf; leaf < group.first_leaf + group.leaf_count; ++leaf) {
        region.box.extend(node_of(tree, leaf).box);
        region.reach = std::max(region.reach, static_cast<double>(node_of(tree, leaf).reach));
    }
    return region;
}

// The numbers of the copies of the box that the region meets on an axis. More copies than these change nothing that
// matters: a box so thin has no particle that could move across it.
FixedArray<int, 2> copies(const Region& region, double length, int axis)
{
    constexpr double kMost = 2;
    const auto copy = [&](double x) { return static_cast<int>(std::clamp(std::floor(x / length), -kMost, kMost)); };
    return {copy(region.box.min()[axis] - region.reach), copy(region.box.max()[axis] + region.reach)};
}

// All particles of the leaves within reach of the region.
void gather(const ParticleTree& tree, const ParticleSet& particles, const Vec3& extent, const Region& region,
            NearGroup& group)
{
    group.neighbourhood.clear();
    group.copies.clear();
    FixedArray<FixedArray<int, 2>, 3> range;
    for (int a = 0; a < 3; ++a)
        range[a] = copies(region, extent[a], a);
    for (int z = range[2][0]; z <= range[2][1]; ++z)
        for (int y = range[1][0]; y <= range[1][1]; ++y)
            for (int x = range[0][0]; x <= range[0][1]; ++x) {
                const CopyNumber number{static_cast<int8_t>(x), static_cast<int8_t>(y), static_cast<int8_t>(z)};
                const MirrorCopy copy(number, extent);
                Eigen::AlignedBox3d box;
                box.extend(copy.origin(region.box.min()));
                box.extend(copy.origin(region.box.max()));
                for_leaves_near(tree, box, region.reach, [&](int32_t leaf) {
                    const auto first = static_cast<int32_t>(leaf * kLeafSize);
                    const auto last =
                        std::min(first + static_cast<int32_t>(kLeafSize), static_cast<int32_t>(particles.size()));
                    for (int32_t i = first; i < last; ++i)
                        if (copy.has(particles.walls[i]))
                            group.neighbourhood.push_back(i);
                });
                group.copies.push_back({number, group.neighbourhood.size()});
            }
}

// A box and how far its particles reach, in the units of a group.
struct Target {
    FixedArray<float, 3> middle, half;
    float reach;
};

Target target_of(const Eigen::AlignedBox3d& box, double reach, const NearGroup& group)
{
    Target t;
    const double scale = 1 / group.unit;
    for (int a = 0; a < 3; ++a) {
        t.middle[a] = static_cast<float>((box.center()[a] - group.centre[a]) * scale);
        t.half[a] = static_cast<float>(0.5 * box.sizes()[a] * scale);
    }
    t.reach = static_cast<float>(reach * scale);
    return t;
}

// How far each place is within reach of a box.
CLEFT_WIDE_VECTORS void measure(const Places& places, const Target box, Array<float>& inside)
{
    const auto beyond = [](float d) { return 0.5F * (d + std::abs(d)); };  // max(d, 0) without a branch
    for (size_t i = 0; i < places.size(); ++i) {
        const float x = beyond(std::abs(places.x[i] - box.middle[0]) - box.half[0]);
        const float y = beyond(std::abs(places.y[i] - box.middle[1]) - box.half[1]);
        const float z = beyond(std::abs(places.z[i] - box.middle[2]) - box.half[2]);
        inside[i] = box.reach * box.reach - (x * x + y * y + z * z);
    }
}

// What one thread needs to choose with.
struct Scratch {
    Places places;
    Array<float> inside;
    Array<uint32_t> chosen;
};

// Drops from the neighbourhood what no particle of the group can feel.
// Whole leaves were gathered, and each leaf of the group looks at all that is kept here.
void drop_far(const Region& region, Scratch& scratch, NearGroup& group)
{
    Places& places = scratch.places;
    scratch.inside.resize(places.size());
    measure(places, target_of(region.box, region.reach, group), scratch.inside);
    size_t kept = 0, i = 0;
    for (NearGroup::CopyRun& run : group.copies) {
        for (; i < run.end; ++i) {
            group.neighbourhood[kept] = group.neighbourhood[i];
            places.x[kept] = places.x[i];
            places.y[kept] = places.y[i];
            places.z[kept] = places.z[i];
            kept += scratch.inside[i] > 0;  // no branch: which are near is hard to foretell
        }
        run.end = kept;
    }
    group.neighbourhood.resize(kept);
    places.resize(kept);
}

void choose(const ParticleTree& tree, Scratch& scratch, NearGroup& group)
{
    const size_t all = scratch.places.size();
    scratch.inside.resize(all);
    scratch.chosen.resize(all * size_t{kLeavesInGroup});
    size_t n = 0;
    for (int32_t l = 0; l < group.leaf_count; ++l) {
        const ParticleTree::Node& leaf = node_of(tree, group.first_leaf + l);
        measure(scratch.places, target_of(leaf.box, static_cast<double>(leaf.reach), group), scratch.inside);
        for (size_t i = 0; i < all; ++i) {
            scratch.chosen[n] = static_cast<uint32_t>(i);
            n += scratch.inside[i] > 0;
        }
        group.chosen_begin[l + 1] = n;
    }
    group.chosen.assign(scratch.chosen.begin(), scratch.chosen.begin() + static_cast<ptrdiff_t>(n));
}

}  // namespace

void read_places(const NearGroup& group, const ParticleSet& particles, const Vec3& extent, Places& places)
{
    places.resize(group.neighbourhood.size());
    const double scale = 1 / group.unit;
    size_t i = 0;
    for (const NearGroup::CopyRun& run : group.copies) {
        const MirrorCopy copy(run.copy, extent);
        const Vec3 factor = copy.sign * scale, shift = (copy.shift - group.centre) * scale;
        for (; i < run.end; ++i) {
            const Vec3& x = particles.x[group.neighbourhood[i]];
            places.x[i] = static_cast<float>(shift[0] + factor[0] * x[0]);
            places.y[i] = static_cast<float>(shift[1] + factor[1] * x[1]);
            places.z[i] = static_cast<float>(shift[2] + factor[2] * x[2]);
        }
    }
}

void find_near(const ParticleTree& tree, const ParticleSet& particles, const Vec3& extent, Array<NearGroup>& groups,
               const Run& run)
{
    // Some 1,000 particles in a chunk; its scratch arrays serve all of them.
    constexpr int64_t kGroupsAtOnce = 16;
    const auto leaves = tree.leaves.count();
    groups.resize(chunk_count(leaves, kLeavesInGroup));
    parallel_for(run, groups.count(), kGroupsAtOnce, [&](int64_t begin, int64_t end) {
        Scratch scratch;
        for (int64_t g = begin; g < end; ++g) {
            NearGroup& group = groups[g];
            group.first_leaf = static_cast<int32_t>(g * kLeavesInGroup);
            group.leaf_count = static_cast<int32_t>(std::min(kLeavesInGroup, leaves - g * kLeavesInGroup));
            const Region region = region_of(tree, group);
            group.centre = region.box.center();
            group.unit = region.reach;
            gather(tree, particles, extent, region, group);
            read_places(group, particles, extent, scratch.places);
            drop_far(region, scratch, group);
            choose(tree, scratch, group);
        }
    });
}

}  // namespace cleft
