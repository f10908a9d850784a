// The near force of the background charge, see forces.hpp.
#pragma once

#include "background/charge.hpp"

namespace cleft
{

// The attraction by the near background charge, at a point where the size is h.
Eigen::Vector3f near_attraction(const SizeSampler& size, const Vec3& x, float h);

}  // namespace cleft
