// Spheres through four points, with bounds that hold in spite of rounding.
#pragma once

#include "delaunay/cell.hpp"

#include <array>
#include <cfloat>
#include <cmath>
#include <limits>

namespace cleft
{

// A corner seen from the point that goes in.
struct SeenCorner {
    Vec3 edge;
    double square;
};

// Neither inside nor outside of the sphere, for any point.
inline void leave_in_doubt(Cell& cell)
{
    cell.centre = {{0, 0, 0}};
    cell.inner = -1;
    cell.outer = std::numeric_limits<float>::infinity();
}

// Two cells at a time, in the two halves of the registers that every processor of this kind has.
using Pair = double __attribute__((vector_size(16)));

struct PairOfCorners {
    Pair x, y, z, square;
    PairOfCorners(const SeenCorner* a, const SeenCorner* b)
        : x{a->edge[0], b->edge[0]}, y{a->edge[1], b->edge[1]}, z{a->edge[2], b->edge[2]}, square{a->square, b->square}
    {
    }
};

struct PairOfSpheres {
    Pair x, y, z;  // the centres
    Pair outer, inner;
    Pair determinant, slack;  // both positive, or nothing of this holds
};

// The spheres through the point at `place` (in the frame of the kernel) and three corners. Lemma: let D be the
// distance of the stored centre from the true one, s that of a point from the stored centre, and r that of `place`. The
// power of the point is (s - r)(s + r) plus an error of at most 2(s + r)D, so it has the sign of s - r wherever
// |s - r| > 2D. The true radius is within D of r. `rounding` bounds the error of a place in the frame.
//   D has two parts: the rounding to float, and the error of the centre before that. The latter is at most 8gr, where g
// is the relative error of the determinant: at most 36 DBL_EPSILON / 2 times the product of the three lengths over the
// determinant, which is less than kDeterminant times that. Where g is not small, neither bound decides anything.
//   The stored centre is not read back as doubles: gcc 12 takes a pair of doubles that were rounded to floats and back
// for the pair itself.
inline PairOfSpheres pair_of_spheres(const Vec3& place, double rounding, const PairOfCorners& a, const PairOfCorners& b,
                                     const PairOfCorners& c)
{
    constexpr double kDeterminant = 4e-15, kGreatestError = 1e-3;
    constexpr double kWorst = kDeterminant * kDeterminant / (kGreatestError * kGreatestError);
    constexpr double kFloat = 0x1p-24;    // of a coordinate, by rounding to float
    constexpr double kToFloat = 0x1p-22;  // more than what a square and its rounding to float can lose
    const Pair bc_x = b.y * c.z - b.z * c.y, bc_y = b.z * c.x - b.x * c.z, bc_z = b.x * c.y - b.y * c.x;
    const Pair det = a.x * bc_x + a.y * bc_y + a.z * bc_z;
    const Pair scale = 0.5 / det;
    // a^2 (b x c) + b^2 (c x a) + c^2 (a x b), with one cross product less.
    const Pair d_x = c.square * b.x - b.square * c.x, d_y = c.square * b.y - b.square * c.y,
               d_z = c.square * b.z - b.square * c.z;
    const Pair x = scale * (a.square * bc_x + (a.y * d_z - a.z * d_y));
    const Pair y = scale * (a.square * bc_y + (a.z * d_x - a.x * d_z));
    const Pair z = scale * (a.square * bc_z + (a.x * d_y - a.y * d_x));
    const Pair square = x * x + y * y + z * z;
    const Pair radius{std::sqrt(square[0]), std::sqrt(square[1])};
    // Each length is below 2.01 radii, and the coordinates of the centre add up to less than 1.75 and those of `place`.
    const Pair relative = 18 * kDeterminant * (square * radius) * scale;
    const Pair sum = place.lpNorm<1>() + 1.75 * radius;
    const Pair error = 3 * (kFloat * sum + 9 * relative * radius) + 4 * rounding;
    const Pair most = radius + error, least = radius - error;
    const Pair outer = most * most * (1 + kToFloat);
    // The sign tells whether there is an inside at all.
    const Pair inner = least * Pair{std::abs(least[0]), std::abs(least[1])} * (1 - kToFloat);
    const Pair slack = det * det - kWorst * (a.square * b.square * c.square);
    return {place[0] + x, place[1] + y, place[2] + z, outer, inner, det, slack};
}

inline void set_spheres_of_pair(const std::array<Cell*, 2>& cells, const PairOfSpheres& s)
{
    constexpr double kLeastDeterminant = 1e-140;
    constexpr double kSmallest = 1e-30, kGreatest = 1e30;  // of floats, with their whole precision
    for (int i = 0; i < 2; ++i) {
        Cell& cell = *cells[to_size(i)];
        if (!cell.is_real() || !(s.determinant[i] > kLeastDeterminant && s.slack[i] > 0 && s.outer[i] < kGreatest)) {
            leave_in_doubt(cell);
            continue;
        }
        cell.centre = {{static_cast<float>(s.x[i]), static_cast<float>(s.y[i]), static_cast<float>(s.z[i])}};
        cell.outer = static_cast<float>(std::max(s.outer[i], kSmallest));
        cell.inner = s.inner[i] > kSmallest ? static_cast<float>(s.inner[i]) : -1;
    }
}

}  // namespace cleft
