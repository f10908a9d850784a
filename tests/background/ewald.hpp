// The exact electrostatic force on particles in a mirrored box with a background charge, by Ewald's sum: a sum of
// cosines for the charges smeared by Gaussians, and a direct sum over near images for the rest. For small sets only.
#pragma once

#include "background/charge.hpp"
#include "background/particle_set.hpp"

#include <cmath>
#include <vector>

namespace ewald
{

using cleft::ParticleSet;
using cleft::SizeSampler;
using cleft::Vec3;

constexpr double kPi = 3.14159265358979323846;

struct Sum {
    const SizeSampler& size;
    Vec3 extent;
    double alpha;              // inverse width of the Gaussians
    std::array<int, 3> waves;  // by axis
};

inline Sum make_sum(const SizeSampler& size, double least_size, double alpha_of_least_size)
{
    Sum sum{size, size.extent(), alpha_of_least_size / least_size, {}};
    for (size_t a = 0; a < 3; ++a)
        sum.waves[a] = 1 + static_cast<int>(2 * 2.6 * sum.alpha * sum.extent[static_cast<int>(a)] / kPi);
    return sum;
}

inline double density(const SizeSampler& size, const Vec3& x)
{
    const double h = static_cast<double>(size(x));
    return cleft::kParticleDensity[3] / (h * h * h);
}

// cos and sin of k x for each wave number of an axis.
inline void waves_at(const Sum& sum, int axis, double x, std::vector<double>& c, std::vector<double>& s)
{
    const auto n = static_cast<size_t>(sum.waves[static_cast<size_t>(axis)]);
    c.resize(n);
    s.resize(n);
    for (size_t k = 0; k < n; ++k) {
        const double phase = kPi * static_cast<double>(k) * x / sum.extent[axis];
        c[k] = std::cos(phase);
        s[k] = std::sin(phase);
    }
}

template <class Visit>
void for_each_wave(const Sum& sum, const Visit& visit)
{
    size_t at = 0;
    for (int z = 0; z < sum.waves[2]; ++z)
        for (int y = 0; y < sum.waves[1]; ++y)
            for (int x = 0; x < sum.waves[0]; ++x, ++at) {
                const Vec3 k = kPi * Vec3(x, y, z).cwiseQuotient(sum.extent);
                if (k.squaredNorm() > 0 && k.norm() < 2 * 2.6 * sum.alpha)
                    visit(at, x, y, z, k);
            }
}

// Amplitudes of the particles less those of the background (midpoint rule on `fine` points an axis).
inline std::vector<double> amplitudes(const Sum& sum, const ParticleSet& particles, int fine)
{
    const int nx = sum.waves[0], ny = sum.waves[1], nz = sum.waves[2];
    std::vector<double> s(static_cast<size_t>(nx) * static_cast<size_t>(ny) * static_cast<size_t>(nz), 0.0);
    std::array<std::vector<double>, 3> c, unused;
    const auto add = [&](const Vec3& x, double charge) {
        for (int a = 0; a < 3; ++a)
            waves_at(sum, a, x[a], c[static_cast<size_t>(a)], unused[static_cast<size_t>(a)]);
        for (int k = 0; k < nz; ++k)
            for (int j = 0; j < ny; ++j) {
                const double w = charge * c[2][static_cast<size_t>(k)] * c[1][static_cast<size_t>(j)];
                double* row = &s[static_cast<size_t>(nx) * static_cast<size_t>(j + ny * k)];
                for (int i = 0; i < nx; ++i)
                    row[i] += w * c[0][static_cast<size_t>(i)];
            }
    };
    for (size_t i = 0; i < particles.size(); ++i)
        add(particles.x[i], cleft::share_of_box(particles.walls[i]));
    // The background, one axis after the other.
    std::array<Eigen::MatrixXd, 3> m;
    for (int a = 0; a < 3; ++a) {
        auto& w = m[static_cast<size_t>(a)];
        w.resize(sum.waves[static_cast<size_t>(a)], fine);
        for (int i = 0; i < fine; ++i) {
            waves_at(sum, a, (i + 0.5) / fine * sum.extent[a], c[0], unused[0]);
            for (Eigen::Index k = 0; k < w.rows(); ++k)
                w(k, i) = c[0][static_cast<size_t>(k)];
        }
    }
    const double cell = sum.extent.prod() / std::pow(fine, 3);
    Eigen::MatrixXd planes(nx * ny, fine);
    for (int z = 0; z < fine; ++z) {
        Eigen::MatrixXd plane(fine, fine);
        for (int y = 0; y < fine; ++y)
            for (int x = 0; x < fine; ++x)
                plane(x, y) =
                    cell * density(sum.size, (Vec3(x, y, z).array() + 0.5).matrix().cwiseProduct(sum.extent) / fine);
        const Eigen::MatrixXd t = m[0] * plane * m[1].transpose();
        planes.col(z) = Eigen::Map<const Eigen::VectorXd>(t.data(), nx * ny);
    }
    const Eigen::MatrixXd all = planes * m[2].transpose();
    Eigen::Map<Eigen::VectorXd>(s.data(), nx * ny * nz) -= Eigen::Map<const Eigen::VectorXd>(all.data(), nx * ny * nz);
    return s;
}

// The force between two unit charges that is not in the smeared sum, over their distance.
inline double near_weight(double alpha, double r)
{
    return (std::erfc(alpha * r) / r + 2 * alpha / std::sqrt(kPi) * std::exp(-alpha * alpha * r * r)) / (r * r);
}

inline Vec3 near_particles(const Sum& sum, const ParticleSet& particles, size_t i)
{
    const double cutoff = 3 / sum.alpha;
    Vec3 force = Vec3::Zero();
    std::array<int, 3> copy;
    for (size_t j = 0; j < particles.size(); ++j)
        for (copy[2] = -1; copy[2] <= 1; ++copy[2])
            for (copy[1] = -1; copy[1] <= 1; ++copy[1])
                for (copy[0] = -1; copy[0] <= 1; ++copy[0]) {
                    Vec3 x = particles.x[j];
                    bool is_image = true;
                    for (int a = 0; a < 3; ++a) {
                        const int n = copy[static_cast<size_t>(a)];
                        if (n != 0 && cleft::held(particles.walls[j], a))
                            is_image = false;
                        x[a] = n == 0 ? x[a] : n < 0 ? -x[a] : 2 * sum.extent[a] - x[a];
                    }
                    const Vec3 d = particles.x[i] - x;
                    const double r = d.norm();
                    if (is_image && r < cutoff && r > 0)
                        force += near_weight(sum.alpha, r) * d;
                }
    return force;
}

inline Vec3 near_background(const Sum& sum, const Vec3& x)
{
    constexpr int kRadii = 16, kPolar = 12, kAround = 16;
    const double step = 3 / sum.alpha / kRadii;
    Vec3 force = Vec3::Zero();
    for (int p = 0; p < kPolar; ++p) {
        const double z = (p + 0.5) / kPolar * 2 - 1, rho = std::sqrt(1 - z * z);
        for (int q = 0; q < kAround; ++q) {
            const double turn = 2 * kPi * (q + 0.5) / kAround;
            const Vec3 d(rho * std::cos(turn), rho * std::sin(turn), z);
            for (int k = 0; k < kRadii; ++k) {
                const double r = (k + 0.5) * step;
                Vec3 y = x + r * d;
                for (int a = 0; a < 3; ++a)
                    y[a] = y[a] < 0 ? -y[a] : y[a] > sum.extent[a] ? 2 * sum.extent[a] - y[a] : y[a];
                force += 4 * kPi / (kPolar * kAround) * step * r * r * r * near_weight(sum.alpha, r) *
                         density(sum.size, y) * d;
            }
        }
    }
    return force;
}

// The force on every particle, unit charges.
inline std::vector<Vec3> forces(const Sum& sum, const ParticleSet& particles, int fine)
{
    const std::vector<double> s = amplitudes(sum, particles, fine);
    std::vector<double> potential(s.size(), 0);
    for_each_wave(sum, [&](size_t at, int x, int y, int z, const Vec3& k) {
        const int twice = (x > 0) + (y > 0) + (z > 0);
        const double k2 = k.squaredNorm();
        potential[at] =
            (1 << twice) / sum.extent.prod() * 4 * kPi / k2 * std::exp(-k2 / (4 * sum.alpha * sum.alpha)) * s[at];
    });
    std::vector<Vec3> out(particles.size());
    std::array<std::vector<double>, 3> c, w;
    for (size_t i = 0; i < particles.size(); ++i) {
        for (int a = 0; a < 3; ++a)
            waves_at(sum, a, particles.x[i][a], c[static_cast<size_t>(a)], w[static_cast<size_t>(a)]);
        Vec3 f = Vec3::Zero();
        for_each_wave(sum, [&](size_t at, int x, int y, int z, const Vec3& k) {
            const auto i0 = static_cast<size_t>(x), i1 = static_cast<size_t>(y), i2 = static_cast<size_t>(z);
            f += potential[at] * Vec3(k[0] * w[0][i0] * c[1][i1] * c[2][i2], k[1] * c[0][i0] * w[1][i1] * c[2][i2],
                                      k[2] * c[0][i0] * c[1][i1] * w[2][i2]);
        });
        out[i] = f + near_particles(sum, particles, i) + near_background(sum, particles.x[i]);
    }
    return out;
}

}  // namespace ewald
