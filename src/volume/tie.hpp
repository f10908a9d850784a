// Where indicator functions tie: on an edge, and next to a vertex.
//
// A vertex of material set S stands for the function max over S of f; the cut of an edge is where the functions of its
// two ends are equal.
#pragma once

#include "volume/material_set.hpp"
#include "volume/volume.hpp"

#include <optional>

namespace cleft
{

// Cuts keep away from the ends of their edges.
// A nearer cut would leave pieces whose volume is lost in rounding. The tie is less exact than this anyway, so that
// such a cut says only which end it is near. The least share in src/cleaving/flat_cuts.cpp follows from this one.
inline constexpr double kLeastCut = 0.02, kGreatestCut = 1 - kLeastCut;

// The value of the best material of a set.
double greatest_value(const Samples& samples, const MaterialSet& set);

// An edge from `a` (materials A) to `b` (materials B); the differences max over A - max over B at its ends are known.
struct EdgeTie {
    const Vec3 &a, &b;
    const MaterialSet &A, &B;
    double difference_a, difference_b;
};

// Parameter of the tie between a (0) and b (1): a bracketed root search of few evaluations. An end that is on the
// wrong side of the tie (voxel-aligned vertices, noise) gives the nearest parameter that is allowed.
double find_cut(const Volume& volume, const EdgeTie& edge, Samples& scratch);

// The point closest to x at which the materials of the set (2 to 4) tie, by minimum-norm Newton steps from `start`, a
// point near the tie (far from interfaces label indicators are flat). The frozen axes (bits) keep x's coordinates.
// None if there are fewer free axes than equations, if the tie is further than `reach`, or without convergence.
std::optional<Vec3> project_to_tie(const Volume& volume, const Vec3& x, const Vec3& start, const MaterialSet& set,
                                   unsigned frozen, double reach, Samples& scratch);

// The first of these steps alone: where functions tie that hardly do, as those of two balls that touch, the steps take
// many, and each leads nearer.
std::optional<Vec3> step_to_tie(const Volume& volume, const Vec3& x, const MaterialSet& set, unsigned frozen,
                                Samples& scratch);

// The point of the tie nearest to x, as nearly as some steps from `start` find it, a point of the tie in whose
// neighbourhood it lies: each takes the point nearest to x of the tie as it is linearised at the last one. None where
// that does not converge, as at a place further from the tie than its radius of curvature.
std::optional<Vec3> nearest_on_tie(const Volume& volume, const Vec3& x, const Vec3& start, const MaterialSet& set,
                                   Samples& scratch);

}  // namespace cleft
