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
    // A face of no area makes the product 0 and the quality no number. It is replaced afterwards, since a branch before
    // the root would keep the compiler from taking several tetrahedra at once.
    return product > 0 ? quality : 0;
}

struct AngleQuality {
    double value;
    Triple gradient;  // with respect to corner a
};

// The same and its gradient. The angle at one edge, the worst, decides: with V six times the volume
//   quality = V l / (|n_k| |n_l|),
// whose logarithmic derivative is a sum of one term for each factor that moves with a.
[[gnu::always_inline]] inline AngleQuality angle_quality_gradient(Triple a, Triple b, Triple c, Triple d)
{
    const Triple ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b, cd = d - c;
    const Triple na = cross(bc, bd), nb = cross(ad, ac), nc = cross(ab, ad), nd = cross(ac, ab);
    const double na2 = dot(na, na), nb2 = dot(nb, nb), nc2 = dot(nc, nc), nd2 = dot(nd, nd);
    const double ab2 = dot(ab, ab), ac2 = dot(ac, ac), ad2 = dot(ad, ad);
    const double na2_nb2 = na2 * nb2, nc2_nd2 = nc2 * nd2;
    const double product = na2_nb2 * nc2_nd2;
    const auto weighted = [](double square, double normals) {
        return square * (normals > 0 ? kObtuseWeight * kObtuseWeight : 1.0);
    };
    const double square[6] = {weighted(ab2 * na2_nb2, dot(nc, nd)),
                              weighted(ac2 * (na2 * nc2), dot(nb, nd)),
                              weighted(ad2 * (na2 * nd2), dot(nb, nc)),
                              weighted(dot(bc, bc) * (nb2 * nc2), dot(na, nd)),
                              weighted(dot(bd, bd) * (nb2 * nd2), dot(na, nc)),
                              weighted(dot(cd, cd) * nc2_nd2, dot(na, nb))};
    // Of each edge in turn: 1 / l^2 for those at a, and whether the faces opposite b, c and d are at it.
    double least = square[0];
    double at_ab = 1 / ab2, at_ac = 0, at_ad = 0;
    double with_b = 0, with_c = 1, with_d = 1;
    // Each value is selected, without a branch, for the same reason as above. On a tie the earlier edge stays, so that
    // the gradient is the same on every machine.
    const auto choose = [&](double value, double to_b, double to_c, double to_d, double b_in, double c_in,
                            double d_in) {
        const bool is_less = value < least;
        least = is_less ? value : least;
        at_ab = is_less ? to_b : at_ab;
        at_ac = is_less ? to_c : at_ac;
        at_ad = is_less ? to_d : at_ad;
        with_b = is_less ? b_in : with_b;
        with_c = is_less ? c_in : with_c;
        with_d = is_less ? d_in : with_d;
    };
    choose(square[1], 0, 1 / ac2, 0, 1, 0, 1);
    choose(square[2], 0, 0, 1 / ad2, 1, 1, 0);
    choose(square[3], 0, 0, 0, 0, 0, 1);
    choose(square[4], 0, 0, 0, 0, 1, 0);
    choose(square[5], 0, 0, 0, 1, 0, 0);
    const double root = product > 0 ? std::sqrt(least / product) : 0;
    const double value = -dot(nd, ad) * root;
    // n = (p - a) x (q - a) has d |n|^2 / 2 = (p - q) x n.
    const Triple from_b = cross(cd, nb), from_c = cross(bd, nc), from_d = cross(bc, nd);
    const double of_b = value * with_b / nb2, of_c = -value * with_c / nc2, of_d = value * with_d / nd2;
    const double to_b = -value * at_ab, to_c = -value * at_ac, to_d = -value * at_ad;
    const auto sum = [&](double n, double p, double q, double r, double u, double v, double w) {
        return -n * root + to_b * p + to_c * q + to_d * r - of_b * u - of_c * v - of_d * w;
    };
    return {value,
            {sum(na.x, ab.x, ac.x, ad.x, from_b.x, from_c.x, from_d.x),
             sum(na.y, ab.y, ac.y, ad.y, from_b.y, from_c.y, from_d.y),
             sum(na.z, ab.z, ac.z, ad.z, from_b.z, from_c.z, from_d.z)}};
}

}  // namespace cleft
