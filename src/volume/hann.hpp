// The kernel that smooths labels, one axis at a time, in units of voxels:
//     w(t) = (1 + cos(2 pi t / width)) / width   for |t| < width / 2, else 0.
// It is C1, and the weights of all voxels add up to one wherever the point lies (for an integer width of 2 or more).
#pragma once

#include "base/fixed_array.hpp"
#include "volume/lanes.hpp"

#include <cmath>
#include <cstdint>

namespace cleft
{

constexpr double kPi = 3.14159265358979323846;

inline double hann(double t, int width)
{
    return std::abs(t) < 0.5 * width ? (1 + std::cos(2 * kPi * t / width)) / width : 0.0;
}

// The weights of the voxels first .. first + width - 1 along each axis, and their derivatives by the position. The
// lanes past the width are zero, so that loops over a row need no remainder.
struct KernelWeights {
    FixedArray<int32_t, 3> first;
    alignas(16) float w[3][kLanes];
    alignas(16) float dw[3][kLanes];
};

class Hann
{
public:
    explicit Hann(int width) : width_(width)
    {
        CLEFT_ASSERT(width >= 2 && width <= kLanes);
        for (int i = 0; i < width; ++i) {
            const double angle = 2 * kPi * (i - 0.5 * (width - 1)) / width;
            mean_[i] = static_cast<float>(1.0 / width);
            cos_[i] = static_cast<float>(std::cos(angle) / width);
            sin_[i] = static_cast<float>(std::sin(angle) / width);
        }
    }

    int width() const { return width_; }

    // Weights for the position u > -1, voxel centres being at integers.
    // cos(2 pi (phi - o) / width) is taken apart by the angle sum: phi, within half a voxel, is the same for all lanes.
    template <bool WithSlopes>
    void weights(const FixedArray<double, 3>& u, KernelWeights& out) const
    {
        // The fourth lane is unused: with it, the compiler makes one vector of the three axes.
        alignas(16) float phi[4] = {}, sine[4], cosine[4];
        for (int a = 0; a < 3; ++a) {
            // A cast truncates towards zero, which is the floor of positive numbers only. The shift is enough for
            // widths up to 8.
            constexpr int kPositive = 4;
            out.first[a] = static_cast<int32_t>(u[a] - 0.5 * width_ + (1 + kPositive)) - kPositive;
            phi[a] = static_cast<float>(u[a] - (out.first[a] + 0.5 * (width_ - 1)));
        }
        const float frequency = static_cast<float>(2 * kPi / width_);
        for (int a = 0; a < 4; ++a)
            sine_cosine(0.5f * frequency * phi[a], sine[a], cosine[a]);
        const FloatRow mean_row = FloatRow::load(mean_), cos_row = FloatRow::load(cos_), sin_row = FloatRow::load(sin_);
        for (int a = 0; a < 3; ++a) {
            (mean_row + (cos_row * cosine[a] + sin_row * sine[a])).store(out.w[a]);
            if (WithSlopes)
                (sin_row * (frequency * cosine[a]) + cos_row * (-frequency * sine[a])).store(out.dw[a]);
        }
    }

private:
    // Of 2 x, by Taylor's series to the last bit of a float: |x| <= pi / 4, as phi is at most 1/2 and the width at
    // least 2.
    static void sine_cosine(float x, float& sine, float& cosine)
    {
        const float q = x * x;
        const float s = x * (1 + q * (-1.f / 6 + q * (1.f / 120 + q * (-1.f / 5040 + q * (1.f / 362880)))));
        const float c = 1 + q * (-1.f / 2 + q * (1.f / 24 + q * (-1.f / 720 + q * (1.f / 40320))));
        sine = 2 * s * c;
        cosine = 1 - 2 * s * s;
    }

    int width_;
    alignas(16) float mean_[kLanes] = {};
    alignas(16) float cos_[kLanes] = {};
    alignas(16) float sin_[kLanes] = {};
};

// The bump that lets a voxel keep its centre: C1, one at its own centre, zero (with zero slope) at all others.
inline double bump(double t)
{
    const double a = 1 - std::abs(t);
    return a > 0 ? a * a * (3 - 2 * a) : 0.0;
}

// d bump / dt
inline double bump_slope(double t)
{
    const double a = 1 - std::abs(t);
    return a > 0 ? (t > 0 ? -6 : 6) * a * (1 - a) : 0.0;
}

}  // namespace cleft
