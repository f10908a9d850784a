// One background tetrahedron with its centres in place: what it splits into, and how well shaped that is.
#pragma once

#include "base/fixed_array.hpp"
#include "cleaving/centres.hpp"

namespace cleft
{

struct SplitTet {
    CutMask cuts = 0;
    StencilTable::Range stencils{};
    FixedArray<Vec3, kStencilPoints> x;  // of the points that are there
};

// `mixed` is the tetrahedron's entry in Centres::mixed.
SplitTet split_tet(const Centres& c, const MixedTet& mixed);

// Chosen anew; its cost is infinite if one of its tetrahedra is not positive.
Fan best_fan(const Centres& c, const MixedTet& mixed);

// For all mixed tetrahedra.
void choose_fans(Centres& c, const Run& run);

// Least of six times the volumes of the tetrahedra of a stencil.
double least_volume(const StencilTable::Tets& tets, const SplitTet& split);

// What a tetrahedron adds to the cost of those around it, 1 / (sine + 0.02)^2: falls when bad ones get better.
// Infinite for a flat or inverted tetrahedron, so no change that makes one is ever taken.
double shape_cost(double least_sine);

}  // namespace cleft
