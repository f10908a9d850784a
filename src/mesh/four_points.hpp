// The corners of one tetrahedron, and what its measures have in common.
#pragma once

#include "mesh/adjacency.hpp"

#include <cmath>

namespace cleft
{

using FourPoints = FixedArray<Vec3, 4>;

// Outward normals of the faces of a positive tetrahedron, twice their areas long; face i is opposite corner i.
inline FixedArray<Vec3, 4> face_normals(const FourPoints& x)
{
    FixedArray<Vec3, 4> normals;
    for (size_t i = 0; i < 4; ++i) {
        const int* f = kFaceCorners[i];
        const Vec3& a = x[f[0]];
        normals[i] = (x[f[1]] - a).cross(x[f[2]] - a);
    }
    return normals;
}

inline double squared_edge(const FourPoints& x, size_t e)
{
    return (x[kEdgeCorners[e][1]] - x[kEdgeCorners[e][0]]).squaredNorm();
}

// Circumradius |p| / (2 |6V|), inradius |6V| / (2 sum of areas).
inline double radius_ratio(const FourPoints& x, const FixedArray<Vec3, 4>& normals, double six_volumes)
{
    Vec3 p = Vec3::Zero();
    double areas = 0;  // twice
    for (size_t i = 0; i < 4; ++i) {
        p += (x[i] - x[0]).squaredNorm() * normals[i];
        areas += normals[i].norm();
    }
    return p.norm() * areas / (6 * six_volumes * six_volumes);
}

}  // namespace cleft
