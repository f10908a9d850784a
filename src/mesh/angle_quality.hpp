// The arithmetic of angle_quality (quality.hpp), in plain numbers, so that loops over several tetrahedra vectorize.
#pragma once

#include "mesh/quality.hpp"

#include <cmath>

namespace cleft
{

struct Triple {
    double x, y, z;
};

inline Triple operator-(Triple a, Triple b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

inline double dot(Triple a, Triple b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

inline Triple cross(Triple a, Triple b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// With faces of areas A, B at an edge of length l, the volume is 2/3 A B sin(angle) / l; with n_i the outward normal of
// the face opposite corner i, twice its area long, the angle at the edge between corners i and j has
//   sine^2 = (6 volume)^2 l^2 / (|n_k|^2 |n_l|^2) = (6 volume)^2 l^2 |n_i|^2 |n_j|^2 / product of all |n|^2.
// One division and one root for six angles, and no branch.
inline double angle_quality(Triple a, Triple b, Triple c, Triple d)
{
    const Triple ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b, cd = d - c;
    const Triple na = cross(bc, bd), nb = cross(ad, ac), nc = cross(ab, ad), nd = cross(ac, ab);
    const double na2 = dot(na, na), nb2 = dot(nb, nb), nc2 = dot(nc, nc), nd2 = dot(nd, nd);
    const double na2_nb2 = na2 * nb2, nc2_nd2 = nc2 * nd2;
    const double product = na2_nb2 * nc2_nd2;
    // The angle is obtuse where the outward normals of its faces are on one side.
    const auto weighted = [](double square, double normals) {
        return square * (normals > 0 ? kObtuseWeight * kObtuseWeight : 1.0);
    };
    const double at_ab = weighted(dot(ab, ab) * na2_nb2, dot(nc, nd));
    const double at_ac = weighted(dot(ac, ac) * (na2 * nc2), dot(nb, nd));
    const double at_ad = weighted(dot(ad, ad) * (na2 * nd2), dot(nb, nc));
    const double at_bc = weighted(dot(bc, bc) * (nb2 * nc2), dot(na, nd));
    const double at_bd = weighted(dot(bd, bd) * (nb2 * nd2), dot(na, nc));
    const double at_cd = weighted(dot(cd, cd) * nc2_nd2, dot(na, nb));
    const auto least = [](double s, double t) { return s < t ? s : t; };
    const double square = least(least(least(at_ab, at_ac), at_ad), least(least(at_bc, at_bd), at_cd));
    const double quality = -dot(nd, ad) * std::sqrt(square / product);
    return product > 0 ? quality : 0;
}

}  // namespace cleft
