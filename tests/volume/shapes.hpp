// Label maps that the tests of the volume stage are made of, and questions to volumes.
#pragma once

#include "base/vec.hpp"
#include "volume/volume.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace cleft::test
{

struct LabelImage {
    Grid grid;
    std::vector<int32_t> voxels;
};

// label(i, j, k) at every voxel.
template <class Label>
LabelImage label_image(const std::array<int32_t, 3>& dims, const Label& label)
{
    LabelImage image;
    image.grid.dims = dims;
    for (int32_t k = 0; k < dims[2]; ++k)
        for (int32_t j = 0; j < dims[1]; ++j)
            for (int32_t i = 0; i < dims[0]; ++i)
                image.voxels.push_back(label(i, j, k));
    return image;
}

inline Array<UserLabel> user_labels(const Array<int32_t>& numbers)
{
    Array<UserLabel> labels;
    for (const int32_t number : numbers)
        labels.push_back(UserLabel{number});
    return labels;
}

// A small generator of random numbers of its own: the same everywhere.
struct Random {
    uint64_t state = 1;
    uint32_t next()
    {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<uint32_t>(state >> 33);
    }
    int32_t below(int32_t n) { return static_cast<int32_t>(next() % static_cast<uint32_t>(n)); }
    double unit() { return next() / 2147483648.0; }
    Vec3 in_box(const Grid& grid) { return Vec3(unit(), unit(), unit()).cwiseProduct(grid.extent()); }
    Vec3 in_ball(double radius)
    {
        for (;;) {
            const Vec3 p = 2 * Vec3(unit(), unit(), unit()) - Vec3::Ones();
            if (p.norm() <= 1)
                return radius * p;
        }
    }
};

inline LabelImage noise_image(const std::array<int32_t, 3>& dims, int32_t labels, uint64_t seed = 1)
{
    Random random{seed};
    return label_image(dims, [&](int32_t, int32_t, int32_t) { return random.below(labels); });
}

inline LabelImage checkerboard_image(const std::array<int32_t, 3>& dims)
{
    return label_image(dims, [](int32_t i, int32_t j, int32_t k) { return (i + j + k) & 1; });
}

// Cells of the nearest of `count` random points: flat interfaces of all directions, triple lines, contact with all
// sides of the box.
inline LabelImage voronoi_image(const std::array<int32_t, 3>& dims, int32_t count, uint64_t seed = 1)
{
    Random random{seed};
    Grid grid;
    grid.dims = dims;
    std::vector<Vec3> seeds;
    for (int32_t s = 0; s < count; ++s)
        seeds.push_back(random.in_box(grid));
    return label_image(dims, [&](int32_t i, int32_t j, int32_t k) {
        const Vec3 x = grid.centre(i, j, k);
        int32_t best = 0;
        for (int32_t s = 1; s < count; ++s)
            if ((x - seeds[static_cast<size_t>(s)]).squaredNorm() <
                (x - seeds[static_cast<size_t>(best)]).squaredNorm())
                best = s;
        return best;
    });
}

inline LabelImage sphere_image(int32_t n, double radius)
{
    const Vec3 centre = Vec3::Constant(0.5 * n);
    return label_image({n, n, n}, [&](int32_t i, int32_t j, int32_t k) {
        return (Vec3(i + 0.5, j + 0.5, k + 0.5) - centre).norm() < radius;
    });
}

inline Volume volume_of(const LabelImage& image, int kernel = 5, int threads = 1)
{
    Run run;
    run.threads = threads;
    return Volume::from_labels(VoxelType::int32, image.voxels.data(), image.grid, kernel, run);
}

// Number of voxel centres at which the field does not hold the voxel's own material.
inline int64_t lost_centres(const Volume& volume)
{
    const Grid& grid = volume.grid();
    int64_t lost = 0, voxel = 0;
    for (int32_t k = 0; k < grid.dims[2]; ++k)
        for (int32_t j = 0; j < grid.dims[1]; ++j)
            for (int32_t i = 0; i < grid.dims[0]; ++i, ++voxel)
                lost += volume.material_at(grid.centre(i, j, k)) != volume.voxel_material(voxel);
    return lost;
}

// Volume of every material in voxels, from n^3 points a voxel.
inline std::vector<double> sampled_volumes(const Volume& volume, int n)
{
    const Grid& grid = volume.grid();
    std::vector<double> sum(static_cast<size_t>(volume.material_count()), 0.0);
    for (int32_t k = 0; k < n * grid.dims[2]; ++k)
        for (int32_t j = 0; j < n * grid.dims[1]; ++j)
            for (int32_t i = 0; i < n * grid.dims[0]; ++i) {
                const Vec3 u = Vec3(i + 0.5, j + 0.5, k + 0.5) / n;
                sum[static_cast<size_t>(volume.material_at(u.cwiseProduct(grid.spacing)))] += 1.0 / (n * n * n);
            }
    return sum;
}

// The greatest difference between a gradient and central differences, relative to the greatest slope of the field, at
// `points` random points. All lengths are in voxels.
inline double gradient_error(const Volume& volume, int points)
{
    const Grid& grid = volume.grid();
    Random random;
    Samples exact, low, high;
    double worst = 0, scale = 0;
    const auto value = [](const Samples& s, Material m) {
        const int i = s.find(m);
        return i < 0 ? 0.0 : s.value[static_cast<size_t>(i)];
    };
    for (int p = 0; p < points; ++p) {
        const Vec3 x = random.in_box(grid);
        volume.sample_gradient(x, exact);
        for (int a = 0; a < 3; ++a) {
            constexpr double h = 2e-3;
            const Vec3 step = h * grid.spacing[a] * Vec3::Unit(a);
            volume.sample(x - step, low);
            volume.sample(x + step, high);
            for (size_t m = 0; m < exact.size(); ++m) {
                const double difference = (value(high, exact.material[m]) - value(low, exact.material[m])) / (2 * h);
                scale = std::max(scale, std::abs(difference));
                // Next to the walls the clamped points make the difference one-sided.
                if (x[a] - step[a] > 0 && x[a] + step[a] < grid.extent()[a])
                    worst = std::max(worst, std::abs(exact.gradient[m][a] * grid.spacing[a] - difference));
            }
        }
    }
    return scale > 0 ? worst / scale : worst;
}

// How often single_material_near is true at random points, or -1 if it was ever wrong at a point within reach.
inline double single_share(const Volume& volume, double reach, int points)
{
    Random random;
    int single = 0;
    for (int p = 0; p < points; ++p) {
        const Vec3 x = random.in_box(volume.grid());
        if (!volume.single_material_near(x, reach))
            continue;
        ++single;
        for (int q = 0; q < 20; ++q)
            if (volume.material_at(x + random.in_ball(reach)) != volume.material_at(x))
                return -1;
    }
    return double(single) / points;
}

// The status and the sentence with which `action` refuses; status 0 if it does not.
struct Refusal {
    cleft_status status = CLEFT_OK;
    std::string sentence;
    bool names(const std::string& word) const { return sentence.find(word) != std::string::npos; }
};

template <class Action>
Refusal refusal(const Action& action)
{
    try {
        action();
    } catch (const Error& error) {
        return {error.status(), error.what()};
    }
    return {};
}

}  // namespace cleft::test
