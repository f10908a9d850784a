// The box of a mesh and its sides.
#pragma once

#include "base/array.hpp"
#include "base/placement.hpp"
#include "mesh/tet_mesh.hpp"

#include <cmath>
#include <limits>

namespace cleft
{

struct BoundingBox {
    Vec3 lo = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 hi = Vec3::Constant(-std::numeric_limits<double>::infinity());

    void add(const Vec3& x)
    {
        lo = lo.cwiseMin(x);
        hi = hi.cwiseMax(x);
    }
    void add(const Array<Vec3>& points)
    {
        for (const Vec3& x : points)
            add(x);
    }
    // True until a point is added.
    bool empty() const { return !(lo[0] <= hi[0]); }
    double square_distance(const Vec3& x) const { return (lo - x).cwiseMax(x - hi).cwiseMax(0).squaredNorm(); }
    double distance(const Vec3& x) const { return std::sqrt(square_distance(x)); }
    double distance(const BoundingBox& other) const
    {
        return (lo - other.hi).cwiseMax(other.lo - hi).cwiseMax(0).norm();
    }
    double longest() const { return empty() ? 0 : (hi - lo).maxCoeff(); }
    double volume() const { return empty() ? 0 : (hi - lo).prod(); }
    // In the world.
    double area(const Placement& world) const
    {
        const Vec3 e = empty() ? Vec3(0, 0, 0) : Vec3(hi - lo);
        const Vec3 x(e[0], 0, 0), y(0, e[1], 0), z(0, 0, e[2]);
        return 2 * (world.area(x, y) + world.area(y, z) + world.area(z, x));
    }

    // The sides that x lies in within `tolerance`, one bit each in the order of Side.
    // A tolerance of 0 compares exactly, as the local frame allows.
    unsigned sides(const Vec3& x, double tolerance) const
    {
        unsigned bits = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (std::abs(x[axis] - lo[axis]) <= tolerance)
                bits |= 1u << (2 * axis);
            if (std::abs(x[axis] - hi[axis]) <= tolerance)
                bits |= 2u << (2 * axis);
        }
        return bits;
    }
};

inline BoundingBox box_of(const Array<Vec3>& points)
{
    BoundingBox box;
    box.add(points);
    return box;
}

}  // namespace cleft
