// Exact orientation.
#pragma once

#include "base/vec.hpp"

namespace cleft
{

// Sign of det[b-a, c-a, d-a], exact for finite doubles without overflow or underflow: -1, 0 or 1.
int orient_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace cleft
