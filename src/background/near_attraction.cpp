#include "background/forces.hpp"

namespace cleft
{

namespace
{

// A quadrature of the sphere that is exact to degree 5: the axes and the diagonals of a cube.
constexpr size_t kDirections = 14, kAxes = 6;
constexpr float kDiagonal = 0.577350269F;
constexpr float kDirection[kDirections][3] = {{1, 0, 0},
                                              {-1, 0, 0},
                                              {0, 1, 0},
                                              {0, -1, 0},
                                              {0, 0, 1},
                                              {0, 0, -1},
                                              {kDiagonal, kDiagonal, kDiagonal},
                                              {-kDiagonal, kDiagonal, kDiagonal},
                                              {kDiagonal, -kDiagonal, kDiagonal},
                                              {-kDiagonal, -kDiagonal, kDiagonal},
                                              {kDiagonal, kDiagonal, -kDiagonal},
                                              {-kDiagonal, kDiagonal, -kDiagonal},
                                              {kDiagonal, -kDiagonal, -kDiagonal},
                                              {-kDiagonal, -kDiagonal, -kDiagonal}};
constexpr float kAxisWeight = 1.0F / 15, kDiagonalWeight = 3.0F / 40;

// Gauss's rule for an integrand t (1 - t^2) g(t^2) on [0, 1], as the weights of f = t g: what remains of opposite
// directions is odd.
constexpr size_t kRadii = 2;
constexpr float kRadius[kRadii] = {0.393765191F, 0.803087152F};
constexpr float kRadiusWeight[kRadii] = {0.403846491F, 0.113286969F};

}  // namespace

Eigen::Vector3f near_attraction(const SizeSampler& size, const Vec3& x, float h)
{
    const float reach = kReach * h;
    const Eigen::Array3f centre = size.to_voxels(x), scale = size.length_to_voxels(reach);
    Eigen::Vector3f force = Eigen::Vector3f::Zero();
    for (size_t d = 0; d < kDirections; ++d) {
        const Eigen::Map<const Eigen::Array3f> direction(kDirection[d]);
        const Eigen::Array3f step = direction * scale;
        float sum = 0;
        for (size_t k = 0; k < kRadii; ++k) {
            const float ratio = h / size.at_voxel(size.mirrored(centre + kRadius[k] * step));
            sum += kRadiusWeight[k] * ratio * ratio * ratio;
        }
        force += (d < kAxes ? kAxisWeight : kDiagonalWeight) * sum * direction.matrix();
    }
    constexpr auto kCharge = static_cast<float>(4 * 3.14159265358979323846 * kParticleDensity[3]);
    return kCharge * kReach * force;
}

}  // namespace cleft
