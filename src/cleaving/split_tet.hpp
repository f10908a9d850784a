// One background tetrahedron with its centres in place: what it splits into, and how well shaped that is.
#pragma once

#include "cleaving/centres.hpp"

namespace cleft
{

struct SplitTet {
    CutMask cuts = 0;
    SplitSurface surface;
    std::array<Vec3, kStencilPoints> x;  // of the points that are there
};

// `mixed` is the tetrahedron's entry in Centres::mixed.
SplitTet split_tet(const Centres& c, const MixedTet& mixed);

// The fan whose worst tetrahedron is best.
struct BestFan {
    int apex = 0;
    double least_sine = -1;
    // Sum over its tetrahedra of 1 / (sine + 0.02)^2, infinite if one is not positive: falls when bad ones get better.
    double cost = 0;
};

BestFan best_fan(const SplitTet& split);

// Least of six times the volumes of a fan.
double least_volume(const SplitTet& split, int apex);

// Of a tetrahedron that does not split.
double shape_cost(double least_sine);

}  // namespace cleft
