// Generated volumes: the shapes that every stage has to survive. Standard C++ alone, so that tests of the C interface
// can use them too.
#pragma once

#include "support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace cleft_test
{

using Dims = std::array<int32_t, 3>;
using Triple = std::array<double, 3>;

inline size_t voxel_count(const Dims& dims)
{
    return static_cast<size_t>(dims[0]) * static_cast<size_t>(dims[1]) * static_cast<size_t>(dims[2]);
}

inline double distance(const Triple& a, const Triple& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

// Values at voxels, x fastest, made by value(i, j, k).
template <class T, class Value>
std::vector<T> fill_voxels(const Dims& dims, const Value& value)
{
    std::vector<T> voxels;
    voxels.reserve(voxel_count(dims));
    for (int32_t k = 0; k < dims[2]; ++k)
        for (int32_t j = 0; j < dims[1]; ++j)
            for (int32_t i = 0; i < dims[0]; ++i)
                voxels.push_back(static_cast<T>(value(i, j, k)));
    return voxels;
}

struct LabelVolume {
    Dims dims{};
    std::vector<uint8_t> voxels;  // x fastest

    uint8_t at(int32_t i, int32_t j, int32_t k) const
    {
        return voxels[static_cast<size_t>(i) +
                      static_cast<size_t>(dims[0]) *
                          (static_cast<size_t>(j) + static_cast<size_t>(dims[1]) * static_cast<size_t>(k))];
    }
};

template <class Value>
LabelVolume make_labels(const Dims& dims, const Value& value)
{
    return {dims, fill_voxels<uint8_t>(dims, value)};
}

// Exact signed distance to a surface, positive inside.
using SignedDistance = std::function<double(const Triple&)>;

inline SignedDistance sphere(const Triple& centre, double radius)
{
    return [=](const Triple& x) { return radius - distance(x, centre); };
}

// Around an axis along z.
inline SignedDistance torus(const Triple& centre, double ring_radius, double tube_radius)
{
    return [=](const Triple& x) {
        const double from_ring = std::hypot(x[0] - centre[0], x[1] - centre[1]) - ring_radius;
        return tube_radius - std::hypot(from_ring, x[2] - centre[2]);
    };
}

// Disjoint solids in a box: label 0 outside, s + 1 in solid s.
struct Scene {
    Dims dims{};
    std::vector<SignedDistance> solids;
    Triple spacing{1, 1, 1};

    Triple centre(int32_t i, int32_t j, int32_t k) const
    {
        return {(i + 0.5) * spacing[0], (j + 0.5) * spacing[1], (k + 0.5) * spacing[2]};
    }

    LabelVolume labels() const
    {
        return make_labels(dims, [&](int32_t i, int32_t j, int32_t k) {
            size_t label = 0;
            for (size_t s = 0; s < solids.size(); ++s)
                if (solids[s](centre(i, j, k)) > 0)
                    label = s + 1;
            return label;
        });
    }

    // The distance of solid s at the voxel centres.
    template <class T>
    std::vector<T> signed_distance(size_t s) const
    {
        return fill_voxels<T>(dims, [&](int32_t i, int32_t j, int32_t k) { return solids[s](centre(i, j, k)); });
    }

    // The distance of all that is in no solid.
    template <class T>
    std::vector<T> outside_distance() const
    {
        return fill_voxels<T>(dims, [&](int32_t i, int32_t j, int32_t k) {
            double inside = -std::numeric_limits<double>::infinity();
            for (const SignedDistance& solid : solids)
                inside = std::max(inside, solid(centre(i, j, k)));
            return -inside;
        });
    }
};

// Two equal spheres that touch in one point, in a box of 2n x n x n.
inline Scene kissing_spheres(int32_t n)
{
    const double radius = 0.4 * n;
    return {{2 * n, n, n},
            {sphere({n - radius, 0.5 * n, 0.5 * n}, radius), sphere({n + radius, 0.5 * n, 0.5 * n}, radius)}};
}

// A sphere and one of a quarter of its radius, a quarter of the small radius apart, in a box of 1.5n x n x n.
inline Scene two_sizes(int32_t n)
{
    const double large = 0.4 * n, small = 0.1 * n;
    return {{n + n / 2, n, n},
            {sphere({0.5 * n, 0.5 * n, 0.5 * n}, large),
             sphere({0.5 * n + large + 1.25 * small, 0.5 * n, 0.5 * n}, small)}};
}

// In a box of n x n x n/2.
inline Scene ring(int32_t n) { return {{n, n, n / 2}, {torus({0.5 * n, 0.5 * n, 0.5 * (n / 2)}, 0.3 * n, 0.12 * n)}}; }

// Voronoi cells of random seeds: grains that fill the box and touch all its sides.
inline LabelVolume voronoi_grains(const Dims& dims, int grains, uint64_t seed = 1)
{
    Random random(seed);
    std::vector<Triple> seeds;
    for (int g = 0; g < grains; ++g) {
        const double x = random.between(0, dims[0]), y = random.between(0, dims[1]), z = random.between(0, dims[2]);
        seeds.push_back({x, y, z});
    }
    return make_labels(dims, [&](int32_t i, int32_t j, int32_t k) {
        const Triple x = {i + 0.5, j + 0.5, k + 0.5};
        const auto nearest = std::min_element(seeds.begin(), seeds.end(), [&](const Triple& a, const Triple& b) {
            return distance(a, x) < distance(b, x);
        });
        return nearest - seeds.begin();
    });
}

inline LabelVolume noise(const Dims& dims, int labels, uint64_t seed = 1)
{
    Random random(seed);
    return make_labels(dims, [&](int32_t, int32_t, int32_t) { return random.below(static_cast<uint64_t>(labels)); });
}

inline LabelVolume checkerboard(const Dims& dims, int32_t cell = 1)
{
    return make_labels(dims, [&](int32_t i, int32_t j, int32_t k) { return (i / cell + j / cell + k / cell) % 2; });
}

// One-voxel sheets across z, three voxels apart.
inline LabelVolume sheets(const Dims& dims)
{
    return make_labels(dims, [](int32_t, int32_t, int32_t k) { return k % 4 == 2; });
}

// One-voxel rods along z, three voxels apart.
inline LabelVolume rods(const Dims& dims)
{
    return make_labels(dims, [](int32_t i, int32_t j, int32_t) { return i % 4 == 2 && j % 4 == 2; });
}

// One voxel in the middle.
inline LabelVolume single_voxel(const Dims& dims)
{
    return make_labels(dims, [&](int32_t i, int32_t j, int32_t k) {
        return i == dims[0] / 2 && j == dims[1] / 2 && k == dims[2] / 2;
    });
}

inline LabelVolume single_label(const Dims& dims, uint8_t label = 7)
{
    return {dims, std::vector<uint8_t>(voxel_count(dims), label)};
}

}  // namespace cleft_test
