#include "background/forces.hpp"

#include "base/parallel.hpp"

#include <cmath>

// The two inner loops for processors with wider vectors as well: the same operations, the same results. Not with
// sanitizers, which start after the functions are resolved.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CLEFT_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define CLEFT_WIDE_VECTORS
#endif

namespace cleft
{

namespace
{

constexpr size_t kLanes = static_cast<size_t>(kLeafSize);

// Particles, or their images, side by side: relative to the centre of a group, in units of its reach.
struct Places {
    std::vector<float> x, y, z;

    size_t size() const { return x.size(); }
    void resize(size_t n)
    {
        for (auto* v : {&x, &y, &z})
            v->resize(n);
    }
};

// Leaves that follow each other are near each other: what is near is looked up for a few at once.
constexpr int64_t kLeavesInGroup = 8;

struct Group {
    Eigen::AlignedBox3d box;
    Vec3 centre;
    float reach = 0;
    Places near;  // leaf by leaf
    // Of one leaf at a time:
    std::vector<float> inside;     // positive for what is near it
    std::vector<uint32_t> chosen;  // the numbers of what is near it
    size_t count = 0;
};

struct Lanes {
    std::array<float, kLanes> x, y, z, reach;
};

// A copy of the box in its mirrors: on an axis where `odd`, x appears at shift - x, elsewhere at shift + x.
struct Copy {
    std::array<bool, 3> odd;
    Vec3 sign, shift;

    Copy(const std::array<int, 3>& number, const Vec3& extent)
    {
        for (size_t a = 0; a < 3; ++a) {
            const auto axis = static_cast<int>(a);
            odd[a] = number[a] % 2 != 0;
            sign[axis] = odd[a] ? -1 : 1;
            shift[axis] = extent[axis] * (odd[a] ? number[a] + 1 : number[a]);
        }
    }
    Vec3 image(const Vec3& x) const { return shift + sign.cwiseProduct(x); }
    // The place whose image is x.
    Vec3 origin(const Vec3& x) const { return sign.cwiseProduct(x - shift); }
    // A particle on a wall is its own image in that wall.
    bool has(Walls walls) const
    {
        return !((odd[0] && held(walls, 0)) || (odd[1] && held(walls, 1)) || (odd[2] && held(walls, 2)));
    }
};

class Repulsion
{
public:
    Repulsion(const ParticleTree& tree, const ParticleSet& particles, const std::vector<float>& reach,
              const Vec3& extent)
        : tree_(tree), particles_(particles), reach_(reach), extent_(extent)
    {
    }

    const ParticleTree::Node& node(int64_t leaf) const
    {
        return tree_.nodes[static_cast<size_t>(tree_.leaves[static_cast<size_t>(leaf)])];
    }

    void gather(int64_t first, int64_t last, Group& group) const
    {
        group.near.resize(0);
        group.box.setEmpty();
        group.reach = 0;
        for (int64_t leaf = first; leaf < last; ++leaf) {
            group.box.extend(node(leaf).box);
            group.reach = std::max(group.reach, node(leaf).reach);
        }
        group.centre = group.box.center();
        const std::array<int, 2> x = copies(group, 0), y = copies(group, 1), z = copies(group, 2);
        std::array<int, 3> number{};
        for (number[2] = z[0]; number[2] <= z[1]; ++number[2])
            for (number[1] = y[0]; number[1] <= y[1]; ++number[1])
                for (number[0] = x[0]; number[0] <= x[1]; ++number[0])
                    gather_copy(Copy(number, extent_), group);
    }

    // The particles of a leaf, or their images; lanes without one are far away.
    Lanes lanes(int64_t leaf, const Copy& copy, const Group& group) const
    {
        constexpr float kFarAway = 1e6F;
        Lanes out{};
        out.x.fill(kFarAway);
        out.reach.fill(1);
        const auto first = static_cast<size_t>(leaf * kLeafSize);
        const size_t count = std::min(kLanes, particles_.size() - first);
        const double scale = 1 / static_cast<double>(group.reach);
        for (size_t i = 0; i < count; ++i) {
            if (!copy.has(particles_.walls[first + i]))
                continue;
            const Vec3 p = (copy.image(particles_.x[first + i]) - group.centre) * scale;
            out.x[i] = static_cast<float>(p.x());
            out.y[i] = static_cast<float>(p.y());
            out.z[i] = static_cast<float>(p.z());
            out.reach[i] = reach_[first + i] / group.reach;
        }
        return out;
    }

    Copy the_box() const { return Copy({0, 0, 0}, extent_); }

private:
    // The numbers of the copies that the group's neighbourhood meets on an axis. More copies than these change
    // nothing that matters: a box so thin has no particle that could move across it.
    std::array<int, 2> copies(const Group& group, int axis) const
    {
        constexpr double kMost = 2;
        const double reach = static_cast<double>(group.reach);
        const auto copy = [&](double x) {
            return static_cast<int>(std::clamp(std::floor(x / extent_[axis]), -kMost, kMost));
        };
        return {copy(group.box.min()[axis] - reach), copy(group.box.max()[axis] + reach)};
    }

    void gather_copy(const Copy& copy, Group& group) const
    {
        Eigen::AlignedBox3d box;
        box.extend(copy.origin(group.box.min()));
        box.extend(copy.origin(group.box.max()));
        for_leaves_near(tree_, box, group.reach, [&](int32_t leaf) {
            const Lanes found = lanes(leaf, copy, group);
            const size_t at = group.near.size();
            group.near.resize(at + kLanes);
            std::copy(found.x.begin(), found.x.end(), &group.near.x[at]);
            std::copy(found.y.begin(), found.y.end(), &group.near.y[at]);
            std::copy(found.z.begin(), found.z.end(), &group.near.z[at]);
        });
    }

    const ParticleTree& tree_;
    const ParticleSet& particles_;
    const std::vector<float>& reach_;
    const Vec3& extent_;
};

// A box and how far its particles reach, in the units of a group.
struct Reach {
    std::array<float, 3> middle, half;
    float reach;
};

Reach reach_of_leaf(const ParticleTree::Node& leaf, const Group& group)
{
    Reach r;
    for (size_t a = 0; a < 3; ++a) {
        const auto axis = static_cast<int>(a);
        const double scale = 1 / static_cast<double>(group.reach);
        r.middle[a] = static_cast<float>((leaf.box.center()[axis] - group.centre[axis]) * scale);
        r.half[a] = static_cast<float>(0.5 * leaf.box.sizes()[axis] * scale);
    }
    r.reach = leaf.reach / group.reach;
    return r;
}

// How far each of the group's neighbours is within reach of the box of a leaf.
CLEFT_WIDE_VECTORS void measure(const Places& near, const Reach box, std::vector<float>& inside)
{
    const auto beyond = [](float d) { return 0.5F * (d + std::abs(d)); };  // max(d, 0) without a branch
    for (size_t i = 0; i < near.size(); ++i) {
        const float x = beyond(std::abs(near.x[i] - box.middle[0]) - box.half[0]);
        const float y = beyond(std::abs(near.y[i] - box.middle[1]) - box.half[1]);
        const float z = beyond(std::abs(near.z[i] - box.middle[2]) - box.half[2]);
        inside[i] = box.reach * box.reach - (x * x + y * y + z * z);
    }
}

void choose(const Reach& box, Group& group)
{
    const size_t all = group.near.size();
    group.inside.resize(all);
    group.chosen.resize(all);
    measure(group.near, box, group.inside);
    size_t n = 0;
    for (size_t leaf = 0; leaf < all; leaf += kLanes) {
        const float* inside = &group.inside[leaf];
        if (*std::max_element(inside, inside + kLanes) <= 0)
            continue;
        for (size_t i = 0; i < kLanes; ++i) {
            group.chosen[n] = static_cast<uint32_t>(leaf + i);
            n += inside[i] > 0;
        }
    }
    group.count = n;
}

// The forces on the particles of a leaf, side by side in the lanes of vectors; the neighbours always in their order.
// A particle meets itself at distance 0, where the weight is finite.
CLEFT_WIDE_VECTORS void repel(const Lanes& leaf, const Group& group, Lanes& force)
{
    const Places& near = group.near;
    std::array<float, kLanes> fx{}, fy{}, fz{}, r2;
    for (size_t i = 0; i < kLanes; ++i)
        r2[i] = leaf.reach[i] * leaf.reach[i];
    for (size_t n = 0; n < group.count; ++n) {
        const uint32_t j = group.chosen[n];
        const float x = near.x[j], y = near.y[j], z = near.z[j];
        for (size_t i = 0; i < kLanes; ++i) {
            const float dx = leaf.x[i] - x, dy = leaf.y[i] - y, dz = leaf.z[i] - z;
            const float s = std::max(dx * dx + dy * dy + dz * dz, 1e-12F);
            const float w = std::max(r2[i] - s, 0.0F) / (r2[i] * s * std::sqrt(s));
            fx[i] += w * dx;
            fy[i] += w * dy;
            fz[i] += w * dz;
        }
    }
    force.x = fx;
    force.y = fy;
    force.z = fz;
}

}  // namespace

void near_repulsion(const ParticleTree& tree, const ParticleSet& particles, const std::vector<float>& reach,
                    const Vec3& extent, std::vector<Eigen::Vector3f>& force, const Run& run)
{
    constexpr int64_t kGroupsAtOnce = 16;
    const Repulsion scene(tree, particles, reach, extent);
    const auto leaves = static_cast<int64_t>(tree.leaves.size());
    parallel_for(run, leaves, kGroupsAtOnce * kLeavesInGroup, [&](int64_t begin, int64_t end) {
        Group group;
        Lanes f;
        for (int64_t leaf = begin; leaf < end; ++leaf) {
            if ((leaf - begin) % kLeavesInGroup == 0)
                scene.gather(leaf, std::min(leaf + kLeavesInGroup, end), group);
            const Lanes own = scene.lanes(leaf, scene.the_box(), group);
            choose(reach_of_leaf(scene.node(leaf), group), group);
            repel(own, group, f);
            const auto first = static_cast<size_t>(leaf * kLeafSize);
            for (size_t i = 0; i < std::min(kLanes, particles.size() - first); ++i) {
                const float h = own.reach[i] / kReach;
                force[first + i] = h * h * Eigen::Vector3f(f.x[i], f.y[i], f.z[i]);
            }
        }
    });
}

}  // namespace cleft
