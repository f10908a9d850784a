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

// Edges, and the outward normals of the faces opposite each corner, twice the areas of the faces long.
struct TetVectors {
    Triple ab, ac, ad, bc, bd, cd;
    Triple na, nb, nc, nd;
};

[[gnu::always_inline]] inline TetVectors tet_vectors(Triple a, Triple b, Triple c, Triple d)
{
    const Triple ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b, cd = d - c;
    return {ab, ac, ad, bc, bd, cd, cross(bc, bd), cross(ad, ac), cross(ab, ad), cross(ac, ab)};
}

// Of the angle at each edge: sine^2 times product / (6 volume)^2, weighted where the angle is obtuse.
struct EdgeSines {
    double ab, ac, ad, bc, bd, cd;
    double product;  // of the squares of all normals
};

// With faces of areas A, B at an edge of length l, the volume is 2/3 A B sin(angle) / l; the angle at the edge between
// corners i and j has
//   sine^2 = (6 volume)^2 l^2 / (|n_k|^2 |n_l|^2) = (6 volume)^2 l^2 |n_i|^2 |n_j|^2 / product of all |n|^2.
// So one division and one root do for six angles, without a branch.
[[gnu::always_inline]] inline EdgeSines edge_sines(const TetVectors& t)
{
    const double na2 = dot(t.na, t.na), nb2 = dot(t.nb, t.nb), nc2 = dot(t.nc, t.nc), nd2 = dot(t.nd, t.nd);
    const double na2_nb2 = na2 * nb2, nc2_nd2 = nc2 * nd2;
    // The angle is obtuse where the outward normals of its faces are on one side.
    const auto weighted = [](double square, double normals) {
        return square * (normals > 0 ? kObtuseWeight * kObtuseWeight : 1.0);
    };
    return {weighted(dot(t.ab, t.ab) * na2_nb2, dot(t.nc, t.nd)),
            weighted(dot(t.ac, t.ac) * (na2 * nc2), dot(t.nb, t.nd)),
            weighted(dot(t.ad, t.ad) * (na2 * nd2), dot(t.nb, t.nc)),
            weighted(dot(t.bc, t.bc) * (nb2 * nc2), dot(t.na, t.nd)),
            weighted(dot(t.bd, t.bd) * (nb2 * nd2), dot(t.na, t.nc)),
            weighted(dot(t.cd, t.cd) * nc2_nd2, dot(t.na, t.nb)),
            na2_nb2 * nc2_nd2};
}

inline double angle_quality(Triple a, Triple b, Triple c, Triple d)
{
    const TetVectors t = tet_vectors(a, b, c, d);
    const EdgeSines at = edge_sines(t);
    const auto least = [](double s, double r) { return s < r ? s : r; };
    const double square = least(least(least(at.ab, at.ac), at.ad), least(least(at.bc, at.bd), at.cd));
    const double quality = -dot(t.nd, t.ad) * std::sqrt(square / at.product);
    // A face of no area makes the product 0 and the quality no number. It is replaced afterwards, since a branch before
    // the root would keep the compiler from taking several tetrahedra at once.
    return at.product > 0 ? quality : 0;
}

// What the gradient needs of the edge whose angle is the worst.
struct WorstEdge {
    double square;                  // its EdgeSines
    double at_ab, at_ac, at_ad;     // 1 / l^2 if it is this edge at corner a, else 0
    double with_b, with_c, with_d;  // 1 if the face opposite the corner is at it, else 0
};

[[gnu::always_inline]] inline WorstEdge worst_edge(const TetVectors& t, const EdgeSines& at)
{
    WorstEdge worst{at.ab, 1 / dot(t.ab, t.ab), 0, 0, 0, 1, 1};
    // Each value is selected, without a branch, for the same reason as above. On a tie the earlier edge stays, so that
    // the gradient is the same on every machine.
    const auto choose = [&](double square, double to_b, double to_c, double to_d, double b_in, double c_in,
                            double d_in) {
        const bool is_less = square < worst.square;
        worst.square = is_less ? square : worst.square;
        worst.at_ab = is_less ? to_b : worst.at_ab;
        worst.at_ac = is_less ? to_c : worst.at_ac;
        worst.at_ad = is_less ? to_d : worst.at_ad;
        worst.with_b = is_less ? b_in : worst.with_b;
        worst.with_c = is_less ? c_in : worst.with_c;
        worst.with_d = is_less ? d_in : worst.with_d;
    };
    choose(at.ac, 0, 1 / dot(t.ac, t.ac), 0, 1, 0, 1);
    choose(at.ad, 0, 0, 1 / dot(t.ad, t.ad), 1, 1, 0);
    choose(at.bc, 0, 0, 0, 0, 0, 1);
    choose(at.bd, 0, 0, 0, 0, 1, 0);
    choose(at.cd, 0, 0, 0, 1, 0, 0);
    return worst;
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
    const TetVectors t = tet_vectors(a, b, c, d);
    const EdgeSines at = edge_sines(t);
    const WorstEdge worst = worst_edge(t, at);
    const double root = at.product > 0 ? std::sqrt(worst.square / at.product) : 0;
    const double value = -dot(t.nd, t.ad) * root;
    // n = (p - a) x (q - a) has d |n|^2 / 2 = (p - q) x n.
    const Triple from_b = cross(t.cd, t.nb), from_c = cross(t.bd, t.nc), from_d = cross(t.bc, t.nd);
    const double of_b = value * worst.with_b / dot(t.nb, t.nb), of_c = -value * worst.with_c / dot(t.nc, t.nc),
                 of_d = value * worst.with_d / dot(t.nd, t.nd);
    const double to_b = -value * worst.at_ab, to_c = -value * worst.at_ac, to_d = -value * worst.at_ad;
    const auto sum = [&](double n, double p, double q, double r, double u, double v, double w) {
        return -n * root + to_b * p + to_c * q + to_d * r - of_b * u - of_c * v - of_d * w;
    };
    return {value,
            {sum(t.na.x, t.ab.x, t.ac.x, t.ad.x, from_b.x, from_c.x, from_d.x),
             sum(t.na.y, t.ab.y, t.ac.y, t.ad.y, from_b.y, from_c.y, from_d.y),
             sum(t.na.z, t.ab.z, t.ac.z, t.ad.z, from_b.z, from_c.z, from_d.z)}};
}

}  // namespace cleft
