// The near forces between particles, see forces.hpp.
#pragma once

#include "background/near_lists.hpp"
#include "background/particle_set.hpp"
#include "base/array.hpp"

namespace cleft
{

// The repulsion of every particle by all near ones and by near images. All arrays in tree order; `reach` is kReach
// times h.
void near_repulsion(const Array<NearGroup>& groups, const ParticleSet& particles, const Array<float>& reach,
                    const Vec3& extent, Array<Eigen::Vector3f>& force, const Run& run);

}  // namespace cleft
