// Who is near whom: for each leaf of the tree the particles, and images of particles, that those of the leaf feel.
//
// The leaves of a group are near each other, so they share one small frame of reference and one neighbourhood, from
// which each leaf chooses. Particles move by a tenth of h a step and those at the rim of the reach are hardly felt: the
// lists serve a few steps, and only positions are read again.
#pragma once

#include "background/mirror.hpp"
#include "background/particle_tree.hpp"
#include "base/array.hpp"
#include "base/fixed_array.hpp"

namespace cleft
{

struct NearGroup {
    // Particles of the neighbourhood up to `end` appear in this copy of the box.
    struct CopyRun {
        CopyNumber copy;
        size_t end;
    };
    // Places are stored in float, relative to `centre`, in units of `unit`.
    Vec3 centre{0, 0, 0};
    double unit = 1;
    int32_t first_leaf = 0, leaf_count = 0;
    Array<int32_t> neighbourhood;  // numbers of particles
    Array<CopyRun> copies;
    Array<uint32_t> chosen;  // of the neighbourhood, by one leaf of the group after the other
    FixedArray<size_t, kLeavesInGroup + 1> chosen_begin{};
};

// Places side by side, as vectors of the processor want them.
struct Places {
    Array<float> x, y, z;

    size_t size() const { return x.size(); }
    void resize(size_t n)
    {
        for (auto* v : {&x, &y, &z})
            v->resize(n);
    }
};

// Where the particles of the group's neighbourhood are now.
void read_places(const NearGroup& group, const ParticleSet& particles, const Vec3& extent, Places& places);

// The lists of all groups, from the boxes and reaches of a fitted tree.
void find_near(const ParticleTree& tree, const ParticleSet& particles, const Vec3& extent, Array<NearGroup>& groups,
               const Run& run);

}  // namespace cleft
