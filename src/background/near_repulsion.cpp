// The push of particles on each other within their reach: the innermost loop of relaxation, eight particles at a time.
#include "background/near_repulsion.hpp"

#include "background/forces.hpp"
#include "base/parallel.hpp"
#include "base/wide_vectors.hpp"

#include <cmath>

namespace cleft
{

namespace
{

struct Lanes {
    FixedArray<float, kLeafSize> x{}, y{}, z{}, reach{};
};

// The particles of a leaf in the frame of a group. Lanes without a particle reach nothing.
Lanes lanes_of(int64_t first, int64_t count, const ParticleSet& particles, const Array<float>& reach,
               const NearGroup& group)
{
    // Finite, for an infinite distance would give NaN in the product with its weight.
    constexpr float kFarAway = -1e6F;
    Lanes out;
    out.x.fill(kFarAway);
    out.reach.fill(1);
    const double scale = 1 / group.unit;
    for (int64_t i = 0; i < count; ++i) {
        const Vec3 p = (particles.x[first + i] - group.centre) * scale;
        out.x[i] = static_cast<float>(p.x());
        out.y[i] = static_cast<float>(p.y());
        out.z[i] = static_cast<float>(p.z());
        out.reach[i] = static_cast<float>(static_cast<double>(reach[first + i]) * scale);
    }
    return out;
}

// The forces on the particles of a leaf, side by side in the lanes of vectors; the neighbours always in their order.
// A particle meets itself at distance 0, where the weight is finite.
CLEFT_WIDE_VECTORS void repel(const Lanes& leaf, const Places& places, const uint32_t* near, size_t count, Lanes& force)
{
    FixedArray<float, kLeafSize> fx{}, fy{}, fz{}, r2;
    for (int64_t i = 0; i < kLeafSize; ++i)
        r2[i] = leaf.reach[i] * leaf.reach[i];
    for (size_t n = 0; n < count; ++n) {
        const float x = places.x[near[n]], y = places.y[near[n]], z = places.z[near[n]];
        for (int64_t i = 0; i < kLeafSize; ++i) {
            const float dx = leaf.x[i] - x, dy = leaf.y[i] - y, dz = leaf.z[i] - z;
            // The bound keeps the quotient finite where a particle meets itself; the zero distance then makes the force
            // 0.
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

void near_repulsion(const Array<NearGroup>& groups, const ParticleSet& particles, const Array<float>& reach,
                    const Vec3& extent, Array<Eigen::Vector3f>& force, const Run& run)
{
    // As in near_lists.cpp.
    constexpr int64_t kGroupsAtOnce = 16;
    parallel_for(run, groups.count(), kGroupsAtOnce, [&](int64_t begin, int64_t end) {
        Places places;
        Lanes f;
        for (int64_t g = begin; g < end; ++g) {
            const NearGroup& group = groups[g];
            read_places(group, particles, extent, places);
            for (int32_t leaf = 0; leaf < group.leaf_count; ++leaf) {
                const int64_t first = (group.first_leaf + leaf) * kLeafSize;
                const int64_t count = std::min(kLeafSize, particles.count() - first);
                const Lanes own = lanes_of(first, count, particles, reach, group);
                const size_t chosen = group.chosen_begin[leaf];
                repel(own, places, group.chosen.data() + chosen, group.chosen_begin[leaf + 1] - chosen, f);
                for (int64_t i = 0; i < count; ++i) {
                    const float h = own.reach[i] / kReach;
                    force[first + i] = h * h * Eigen::Vector3f(f.x[i], f.y[i], f.z[i]);
                }
            }
        }
    });
}

}  // namespace cleft
