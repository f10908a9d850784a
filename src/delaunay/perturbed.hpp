// The in-sphere test that never ties.
#pragma once

#include "base/fixed_array.hpp"
#include "base/vec.hpp"

#include <cstdint>

namespace cleft
{

// A point with its number, which decides ties.
struct NumberedPoint {
    const Vec3* x;
    int32_t number;
};

// Thrown where two points are at one place.
struct TwoAtOnePlace {
};

// Is e inside the sphere of the positive tetrahedron? Points that lie on one sphere are told apart as if each were
// raised a little above the paraboloid over which Delaunay tetrahedra are a convex hull, a point of a greater number
// infinitely more than those of lesser ones (Devillers and Teillaud, "Perturbations for Delaunay and weighted Delaunay
// 3D triangulations", 2011). So the tetrahedra follow from the points and their numbers alone, and none is flat.
bool inside_perturbed_sphere(const FixedArray<NumberedPoint, 4>& tet, const NumberedPoint& e);

}  // namespace cleft
