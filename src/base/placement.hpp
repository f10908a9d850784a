// Where a local frame lies in the world of the user: the stages work in one whose axes are those of the voxels.
#pragma once

#include "base/vec.hpp"

#include <Eigen/LU>

#include <cmath>

namespace cleft
{

struct Placement {
    Mat3 linear = Mat3::Identity();  // world = linear * local + offset
    Vec3 offset = Vec3::Zero();

    Vec3 to_world(const Vec3& local) const { return linear * local + offset; }
    double volume(double local) const { return std::abs(linear.determinant()) * local; }
    // Of the parallelogram of two edges.
    double area(const Vec3& a, const Vec3& b) const { return (linear * a).cross(linear * b).norm(); }
};

}  // namespace cleft
