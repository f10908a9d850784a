// Spheres through four points, with bounds that hold in spite of rounding.
#pragma once

#include "delaunay/cell.hpp"

#include <cfloat>
#include <cmath>

namespace cleft
{

// A corner seen from the point that goes in.
struct SeenCorner {
    Vec3 edge;
    double square;
};

// Sets the sphere through the point at `place` (in the frame of the kernel) and three corners. Lemma: let D be the
// distance of the stored centre from the true one, s that of a point from the stored centre, and r that of `place`. The
// power of the point is (s - r)(s + r) plus an error of at most 2(s + r)D, so it has the sign of s - r wherever
// |s - r| > 2D. The true radius is within D of r. `rounding` bounds the error of a place in the frame.
//   D has two parts: the rounding to float, and the error of the centre before that. The latter is at most 8gr, where g
// is the relative error of the determinant: at most 36 DBL_EPSILON / 2 times the product of the three lengths over the
// determinant, which is less than kDeterminant times that. Where g is not small, neither bound decides anything.
//   The stored centre is not read back as doubles: gcc 12 takes a pair of doubles that were rounded to floats and back
// for the pair itself.
inline void set_sphere(Cell& cell, const Vec3& place, double rounding, const SeenCorner& a, const SeenCorner& b,
                       const SeenCorner& c)
{
    constexpr double kDeterminant = 4e-15, kLeastDeterminant = 1e-140, kGreatestError = 1e-3;
    constexpr double kFloat = 0x1p-24;    // of a coordinate, by rounding to float
    constexpr double kToFloat = 0x1p-22;  // more than what a square and its rounding to float can lose
    const Vec3 bc = b.edge.cross(c.edge);
    const double det = a.edge.dot(bc);
    const double lengths = std::sqrt(a.square * b.square * c.square);
    cell.centre = {{0, 0, 0}};
    cell.inner = -1;
    cell.outer = std::numeric_limits<float>::infinity();
    if (!(det > kLeastDeterminant && kDeterminant * lengths < kGreatestError * det))
        return;
    const double scale = 0.5 / det;
    const Vec3 offset = scale * (a.square * bc + b.square * c.edge.cross(a.edge) + c.square * a.edge.cross(b.edge));
    const Vec3 centre = place + offset;
    const double radius = offset.norm();
    const double error = 3 * (kFloat * centre.lpNorm<1>() + 9 * kDeterminant * lengths / det * radius) + 4 * rounding;
    const double most = (radius + error) * (radius + error), least = radius - error;
    constexpr double kSmallest = 1e-30, kGreatest = 1e30;  // of floats, with their whole precision
    if (!(most < kGreatest))
        return;
    cell.centre = {{static_cast<float>(centre[0]), static_cast<float>(centre[1]), static_cast<float>(centre[2])}};
    cell.outer = static_cast<float>(std::max(most, kSmallest) * (1 + kToFloat));
    if (least > 0 && least * least > kSmallest)
        cell.inner = static_cast<float>(least * least * (1 - kToFloat));
}

}  // namespace cleft
