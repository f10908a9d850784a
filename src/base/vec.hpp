// The one vector type of the project: 24 bytes, so an array of Vec3 is an xyz-interleaved array of double.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace cleft
{

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

static_assert(sizeof(Vec3) == 3 * sizeof(double), "points are handed to C as xyz-interleaved doubles");

}  // namespace cleft
