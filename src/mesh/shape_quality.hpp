// The arithmetic of angle_quality() and shape_quality() (quality.hpp), in plain numbers, so that loops over several
// tetrahedra vectorize.
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

// The least of EdgeSines.
[[gnu::always_inline]] inline double least_square(const EdgeSines& at)
{
    const auto least = [](double s, double r) { return s < r ? s : r; };
    return least(least(least(at.ab, at.ac), at.ad), least(least(at.bc, at.bd), at.cd));
}

// What the radius ratio R / (3 r) is made of. With
//   N = |da|^2 db x dc + |db|^2 dc x da + |dc|^2 da x db,
// V six times the volume and S the sum of the lengths of the normals, R = |N| / (2 V) and r = V / S.
// S <= 2 sqrt(sum of their squares), so that one root does. The ratio comes out too large by 15 % for needles, and by
// 42 % at most.
struct RatioParts {
    Triple n;       // N
    double square;  // of N
    double areas;   // sum of the squares of the normals
};

[[gnu::always_inline]] inline RatioParts ratio_parts(const TetVectors& t)
{
    // db x dc = na, dc x da = nb, da x db = nc.
    const double a = dot(t.ad, t.ad), b = dot(t.bd, t.bd), c = dot(t.cd, t.cd);
    const Triple n{a * t.na.x + b * t.nb.x + c * t.nc.x, a * t.na.y + b * t.nb.y + c * t.nc.y,
                   a * t.na.z + b * t.nb.z + c * t.nc.z};
    return {n, dot(n, n), dot(t.na, t.na) + dot(t.nb, t.nb) + dot(t.nc, t.nc) + dot(t.nd, t.nd)};
}

// (kRatioWeight / ratio)^2 / V^2
[[gnu::always_inline]] inline double ratio_square(const RatioParts& parts, double volume)
{
    return 9 * kRatioWeight * kRatioWeight * volume * volume / (parts.square * parts.areas);
}

[[gnu::always_inline]] inline double angle_quality(Triple a, Triple b, Triple c, Triple d)
{
    const TetVectors t = tet_vectors(a, b, c, d);
    const EdgeSines at = edge_sines(t);
    return at.product > 0 ? -dot(t.nd, t.ad) * std::sqrt(least_square(at) / at.product) : 0;
}

[[gnu::always_inline]] inline double shape_quality(Triple a, Triple b, Triple c, Triple d)
{
    const TetVectors t = tet_vectors(a, b, c, d);
    const EdgeSines at = edge_sines(t);
    const double volume = -dot(t.nd, t.ad);
    const double by_angle = least_square(at) / at.product, by_ratio = ratio_square(ratio_parts(t), volume);
    const double quality = volume * std::sqrt(by_ratio < by_angle ? by_ratio : by_angle);
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

struct ShapeQuality {
    double value;
    Triple gradient;  // with respect to corner a
};

// The half gradients of the squares of the normals that move with a: n = (p - a) x (q - a) has
//   d |n|^2 / 2 = (p - q) x n.
// That of nc is turned round.
struct NormalGradients {
    Triple from_b, from_c, from_d;
};

[[gnu::always_inline]] inline NormalGradients normal_gradients(const TetVectors& t)
{
    return {cross(t.cd, t.nb), cross(t.bd, t.nc), cross(t.bc, t.nd)};
}

// The angle at one edge, the worst, decides: with V six times the volume
//   quality = V l / (|n_k| |n_l|),
// whose logarithmic derivative is a sum of one term for each factor that moves with a.
// Without a branch.
[[gnu::always_inline]] inline ShapeQuality angle_quality_gradient(Triple a, Triple b, Triple c, Triple d)
{
    const TetVectors t = tet_vectors(a, b, c, d);
    const EdgeSines at = edge_sines(t);
    const WorstEdge worst = worst_edge(t, at);
    const double root = at.product > 0 ? std::sqrt(worst.square / at.product) : 0;
    const double value = -dot(t.nd, t.ad) * root;
    const auto [from_b, from_c, from_d] = normal_gradients(t);
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

// The inverse of the radius ratio is V^2 / |N| / sqrt(areas) up to a factor. With V and the areas as above,
//   d |N|^2 / 2 = -2 (N . na) ad - |bd|^2 N x cd + |cd|^2 N x bd.
// For the few tetrahedra whose radius ratio decides: `value` is their shape_quality().
inline Triple ratio_quality_gradient(Triple a, Triple b, Triple c, Triple d, double value)
{
    const TetVectors t = tet_vectors(a, b, c, d);
    const RatioParts parts = ratio_parts(t);
    const double of_volume = -2 * value / dot(t.nd, t.ad), of_areas = value / parts.areas, of_n = value / parts.square;
    const double along = 2 * dot(parts.n, t.na) * of_n, b2 = dot(t.bd, t.bd) * of_n, c2 = dot(t.cd, t.cd) * of_n;
    const Triple n_cd = cross(parts.n, t.cd), n_bd = cross(parts.n, t.bd);
    const auto [from_b, from_c, from_d] = normal_gradients(t);
    const auto sum = [&](double n, double ad, double cd, double bd, double u, double v, double w) {
        return -of_volume * n + along * ad + b2 * cd - c2 * bd - of_areas * (u - v + w);
    };
    return {sum(t.na.x, t.ad.x, n_cd.x, n_bd.x, from_b.x, from_c.x, from_d.x),
            sum(t.na.y, t.ad.y, n_cd.y, n_bd.y, from_b.y, from_c.y, from_d.y),
            sum(t.na.z, t.ad.z, n_cd.z, n_bd.z, from_b.z, from_c.z, from_d.z)};
}

}  // namespace cleft
