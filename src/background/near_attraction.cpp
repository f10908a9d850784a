// The pull of the background on a particle within its reach, by a quadrature whose sample points are the same for all
// particles.
#include "background/near_attraction.hpp"

#include "background/forces.hpp"
#include "base/wide_vectors.hpp"

namespace cleft
{

namespace
{

// A quadrature of the sphere that is exact to degree 5, the axes and the diagonals of a cube; one of each pair of
// opposite directions.
constexpr size_t kDirections = 7, kAxes = 3;
constexpr float kDiagonal = 0.577350269F;
constexpr float kDirection[kDirections][3] = {{1, 0, 0},
                                              {0, 1, 0},
                                              {0, 0, 1},
                                              {kDiagonal, kDiagonal, kDiagonal},
                                              {-kDiagonal, kDiagonal, kDiagonal},
                                              {kDiagonal, -kDiagonal, kDiagonal},
                                              {kDiagonal, kDiagonal, -kDiagonal}};
// Exact for polynomials of the fifth degree on the sphere (Stroud 1971, U3: 5-2): by symmetry the odd ones vanish, and
// the two weights are those for which x^2 and x^4 have their means 1/3 and 1/5. Each stands for a pair of opposite
// directions, so the seven add up to 1/2.
constexpr float kAxisWeight = 1.0F / 15, kDiagonalWeight = 3.0F / 40;

// Gauss's rule for an integrand t (1 - t^2) g(t^2) on [0, 1], as the weights of f = t g: what remains of opposite
// directions is odd.
constexpr size_t kRadii = 2;
constexpr float kRadius[kRadii] = {0.393765191F, 0.803087152F};
constexpr float kRadiusWeight[kRadii] = {0.403846491F, 0.113286969F};

// One half of the sample points, side by side: sample n and its opposite, n + kHalf, differ in sign.
constexpr size_t kHalf = kDirections * kRadii, kSamples = 2 * kHalf;

struct Rule {
    std::array<std::array<float, kSamples>, 3> offset{};  // in units of the reach
    std::array<std::array<float, kHalf>, 3> weight{};     // by component of the force
};

constexpr Rule make_rule()
{
    Rule rule;
    for (size_t n = 0; n < kHalf; ++n) {
        const size_t d = n / kRadii, k = n % kRadii;
        for (size_t a = 0; a < 3; ++a) {
            rule.offset[a][n] = kRadius[k] * kDirection[d][a];
            rule.offset[a][n + kHalf] = -rule.offset[a][n];
            rule.weight[a][n] = kRadiusWeight[k] * (d < kAxes ? kAxisWeight : kDiagonalWeight) * kDirection[d][a];
        }
    }
    return rule;
}

constexpr Rule kRule = make_rule();

using Values = std::array<float, kSamples>;

// The charge of the background at the sample points around a particle where the size is h, in units of that at the
// particle. SizeSampler::at_voxel of mirrored places, all samples side by side.
CLEFT_WIDE_VECTORS void read_charges(const SizeSampler::Table& table, const std::array<float, 3>& centre,
                                     const std::array<float, 3>& reach, float h, Values& charge)
{
    std::array<Values, 3> share;
    std::array<int32_t, kSamples> corner{};
    for (size_t a = 0; a < 3; ++a) {
        const float wall = table.walls[a];
        const int32_t last = table.last[a], stride = table.stride[a];
        for (size_t n = 0; n < kSamples; ++n) {
            const float u = centre[a] + kRule.offset[a][n] * reach[a];
            // Mirrors at both walls without a branch: first at the low one, which lies half a voxel before the first
            // centre.
            const float inside = std::abs(u + 0.5F) - 0.5F;
            const float v = std::max(0.0F, wall - std::abs(wall - inside));
            const int32_t voxel = std::min(static_cast<int32_t>(v), last);
            share[a][n] = std::min(v - static_cast<float>(voxel), 1.0F);
            corner[n] += voxel * stride;
        }
    }
    for (size_t n = 0; n < kSamples; ++n) {
        const auto row = [&](const float* p) { return mix(p[0], p[table.stride[0]], share[0][n]); };
        const auto plane = [&](const float* p) { return mix(row(p), row(p + table.stride[1]), share[1][n]); };
        const float* p = table.h + corner[n];
        const float ratio = h / mix(plane(p), plane(p + table.stride[2]), share[2][n]);
        charge[n] = ratio * ratio * ratio;
    }
}

}  // namespace

Eigen::Vector3f near_attraction(const SizeSampler& size, const Vec3& x, float h)
{
    const Eigen::Array3f centre = size.to_voxels(x), reach = size.length_to_voxels(kReach * h);
    Values charge;
    read_charges(size.table(), {centre[0], centre[1], centre[2]}, {reach[0], reach[1], reach[2]}, h, charge);
    std::array<float, 3> force{};
    for (size_t n = 0; n < kHalf; ++n) {
        // Only the difference of opposite points pulls: where h is constant, the force is exactly 0.
        const float more = charge[n] - charge[n + kHalf];
        for (size_t a = 0; a < 3; ++a)
            force[a] += more * kRule.weight[a][n];
    }
    return static_cast<float>(kBackgroundDivergence) * kReach * Eigen::Vector3f(force[0], force[1], force[2]);
}

}  // namespace cleft
