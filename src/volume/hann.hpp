// The kernel that smooths labels, one axis at a time, in units of voxels:
//     w(t) = (1 + cos(2 pi t / width)) / width   for |t| < width / 2, else 0.
// It is C1, and the weights of all voxels add up to one wherever the point lies (for an integer width of 2 or more).
#pragma once

#include <cmath>
#include <cstdint>

namespace cleft
{

// Weights come in rows of eight lanes, zero past the kernel's width, so that loops over a row need no remainder.
constexpr int kLanes = 8;

// The weights of the voxels first .. first + width - 1, and their derivatives by the position.
struct AxisWeights {
    int32_t first = 0;
    alignas(32) float w[kLanes] = {};
    alignas(32) float dw[kLanes] = {};
};

constexpr double kPi = 3.14159265358979323846;

inline double hann(double t, int width)
{
    return std::abs(t) < 0.5 * width ? (1 + std::cos(2 * kPi * t / width)) / width : 0.0;
}

class Hann
{
public:
    explicit Hann(int width) : width_(width)
    {
        for (int i = 0; i < width; ++i) {
            const double angle = 2 * kPi * (i - 0.5 * (width - 1)) / width;
            mean_[i] = static_cast<float>(1.0 / width);
            cos_[i] = static_cast<float>(std::cos(angle) / width);
            sin_[i] = static_cast<float>(std::sin(angle) / width);
        }
    }

    int width() const { return width_; }

    // Weights for the position u, voxel i being at u = i.
    // cos(2 pi (phi - o) / width) is taken apart by the angle sum: phi, within half a voxel, is the same for all lanes.
    void weights(double u, AxisWeights& out) const
    {
        const double first = std::floor(u - 0.5 * width_ + 1);
        const double phi = u - first - 0.5 * (width_ - 1);
        double s, c;
        sine_cosine(kPi * phi / width_, s, c);
        const float sine = static_cast<float>(2 * s * c);
        const float cosine = static_cast<float>(1 - 2 * s * s);
        const float slope = static_cast<float>(-2 * kPi / width_);
        out.first = static_cast<int32_t>(first);
        for (int i = 0; i < kLanes; ++i) {
            out.w[i] = mean_[i] + (cosine * cos_[i] + sine * sin_[i]);
            out.dw[i] = slope * (sine * cos_[i] - cosine * sin_[i]);
        }
    }

private:
    // Taylor's series; |x| <= pi / 4 because half a voxel of a kernel of two is the most that is asked for.
    static void sine_cosine(double x, double& s, double& c)
    {
        const double q = x * x;
        s = x * (1 - q / 6 * (1 - q / 20 * (1 - q / 42 * (1 - q / 72 * (1 - q / 110 * (1 - q / 156))))));
        c = 1 - q / 2 * (1 - q / 12 * (1 - q / 30 * (1 - q / 56 * (1 - q / 90 * (1 - q / 132 * (1 - q / 182))))));
    }

    int width_;
    alignas(32) float mean_[kLanes] = {};
    alignas(32) float cos_[kLanes] = {};
    alignas(32) float sin_[kLanes] = {};
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
