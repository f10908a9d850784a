// Labellings for the tests of sizing: shapes, noise and real-like mixtures of both.
#pragma once

#include "sizing/labelling.hpp"

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace sizing_test
{

// A small generator of its own, so that tests are the same everywhere.
class Random
{
public:
    explicit Random(uint64_t seed) : state_(seed) {}
    uint32_t next()
    {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<uint32_t>(state_ >> 33);
    }
    double uniform() { return next() / 2147483648.0; }

private:
    uint64_t state_;
};

struct Labels {
    cleft::Grid grid;
    std::vector<cleft::Material> values;

    cleft::Labelling labelling() const
    {
        return {grid, [this](int64_t first, int64_t count, cleft::Material* out) {
                    std::copy_n(values.begin() + first, count, out);
                }};
    }
};

inline cleft::Grid grid_of(int32_t nx, int32_t ny, int32_t nz, cleft::Vec3 spacing = {1, 1, 1})
{
    cleft::Grid grid;
    grid.dims = {nx, ny, nz};
    grid.spacing = spacing;
    return grid;
}

inline Labels labels_from(const cleft::Grid& grid, const std::function<cleft::Material(const cleft::Vec3&)>& material)
{
    Labels labels{grid, {}};
    labels.values.reserve(static_cast<size_t>(grid.size()));
    for (int32_t k = 0; k < grid.dims[2]; ++k)
        for (int32_t j = 0; j < grid.dims[1]; ++j)
            for (int32_t i = 0; i < grid.dims[0]; ++i)
                labels.values.push_back(material(grid.centre(i, j, k)));
    return labels;
}

inline Labels ball(const cleft::Grid& grid, const cleft::Vec3& centre, double radius)
{
    return labels_from(grid, [=](const cleft::Vec3& x) { return (x - centre).norm() < radius ? 1 : 0; });
}

inline Labels noise(const cleft::Grid& grid, uint32_t labels, uint64_t seed)
{
    Random random(seed);
    return labels_from(grid, [&](const cleft::Vec3&) { return static_cast<cleft::Material>(random.next() % labels); });
}

// Voronoi cells of random points, with their borders made ragged: close to a segmented image.
inline Labels ragged_cells(const cleft::Grid& grid, int cells, double ragged, uint64_t seed)
{
    Random random(seed);
    std::vector<cleft::Vec3> points;
    for (int n = 0; n < cells; ++n) {
        const double x = random.uniform(), y = random.uniform(), z = random.uniform();
        points.push_back(cleft::Vec3(x, y, z).cwiseProduct(grid.extent()));
    }
    return labels_from(grid, [&](const cleft::Vec3& x) {
        cleft::Material best = 0;
        double least = INFINITY;
        for (size_t n = 0; n < points.size(); ++n) {
            const double d = (points[n] - x).norm() + ragged * random.uniform();
            if (d < least) {
                least = d;
                best = static_cast<cleft::Material>(n);
            }
        }
        return best;
    });
}

}  // namespace sizing_test
