// Exact predicates of points.
#pragma once

#include "base/vec.hpp"

namespace cleft
{

// Sign of det[b-a, c-a, d-a], exact for finite doubles without overflow or underflow: -1, 0 or 1.
int orient_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

// Where e lies of the sphere through the corners of a positive tetrahedron: 1 inside, -1 outside, 0 on it. Exact for
// finite doubles without overflow.
int in_sphere_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

}  // namespace cleft
