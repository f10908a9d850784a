// Points of a box for the tests of the background: the corners first, some points exactly on the walls.
#pragma once

#include "base/array.hpp"
#include "base/vec.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <cstdint>

namespace cleft_test
{

using cleft::Vec3;

inline Vec3 random_in_box(Random& random, const Vec3& extent)
{
    const double x = random.unit(), y = random.unit(), z = random.unit();
    return Vec3(x, y, z).cwiseProduct(extent);
}

// The corners of the box [0, extent], then random points of which one in ten lies on a wall.
inline cleft::Array<Vec3> random_points(int count, const Vec3& extent, uint64_t seed)
{
    Random random(seed);
    cleft::Array<Vec3> points;
    for (int c = 0; c < 8; ++c)
        points.push_back(Vec3(c & 1, (c >> 1) & 1, c >> 2).cwiseProduct(extent));
    while (static_cast<int>(points.size()) < count) {
        Vec3 p = random_in_box(random, extent);
        const int axis = static_cast<int>(points.size()) % 30;
        if (axis < 3)
            p[axis] = random.unit() < 0.5 ? 0.0 : extent[axis];
        points.push_back(p);
    }
    return points;
}

inline cleft::Array<Vec3> cubic_lattice(int n)
{
    cleft::Array<Vec3> points;
    for (int k = 0; k <= n; ++k)
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i)
                points.emplace_back(i, j, k);
    return points;
}

// The cubic lattice and the centres of its cells, moved at random by `jitter` cells at most along each axis; points of
// the walls stay on their walls.
inline cleft::Array<Vec3> bcc_lattice(int n, double jitter, uint64_t seed)
{
    Random random(seed);
    cleft::Array<Vec3> points = cubic_lattice(n);
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                points.emplace_back(i + 0.5, j + 0.5, k + 0.5);
    for (Vec3& p : points)
        for (int a = 0; a < 3; ++a) {
            const double move = random.between(-jitter, jitter);
            if (p[a] > 0 && p[a] < n)
                p[a] += move;
        }
    return points;
}

// Random points of the unit box no nearer to each other than about 0.8 of the wanted edge length, which grows from
// `size` by `gradation` with the distance from the corner 0: corners, then edges, faces and the inside.
class PoissonPoints
{
public:
    PoissonPoints(double size, double gradation, uint64_t seed)
        : size_(size),
          gradation_(gradation),
          cells_(static_cast<int>(0.5 / size) + 1),
          random_(seed),
          buckets_(static_cast<size_t>(cells_) * static_cast<size_t>(cells_) * static_cast<size_t>(cells_))
    {
        for (int c = 0; c < 8; ++c)
            add(Vec3(c & 1, (c >> 1) & 1, c >> 2));
        const double n = 1 / size;
        for (int axis = 0; axis < 3; ++axis)
            throw_darts(static_cast<int>(40 * n), 7 ^ (1 << axis));
        for (int axis = 0; axis < 3; ++axis)
            throw_darts(static_cast<int>(20 * n * n), 1 << axis);
        throw_darts(static_cast<int>(10 * n * n * n), 0);
    }

    cleft::Array<Vec3> points;
    cleft::Array<double> size_at;

private:
    double wanted(const Vec3& x) const { return size_ + gradation_ * x.norm(); }

    // Points with the axes of `walls` on one of the two walls, the others away from their walls.
    void throw_darts(int count, int walls)
    {
        for (int i = 0; i < count; ++i) {
            Vec3 x = random_in_box(random_, Vec3(1, 1, 1));
            const double margin = 0.5 * wanted(x);
            bool fits = true;
            for (int a = 0; a < 3; ++a)
                if (walls >> a & 1)
                    x[a] = x[a] < 0.5 ? 0 : 1;
                else
                    fits = fits && x[a] > margin && x[a] < 1 - margin;
            if (fits && free_at(x))
                add(x);
        }
    }

    int cell(double x) const { return std::clamp(static_cast<int>(x * cells_), 0, cells_ - 1); }

    template <class Visit>
    void for_buckets_near(const Vec3& x, double radius, const Visit& visit)
    {
        for (int k = cell(x.z() - radius); k <= cell(x.z() + radius); ++k)
            for (int j = cell(x.y() - radius); j <= cell(x.y() + radius); ++j)
                for (int i = cell(x.x() - radius); i <= cell(x.x() + radius); ++i)
                    visit(buckets_[i + cells_ * (j + cells_ * k)]);
    }

    bool free_at(const Vec3& x)
    {
        bool is_free = true;
        const double radius = 0.8 * wanted(x);
        for_buckets_near(x, radius, [&](const cleft::Array<int>& bucket) {
            for (const int p : bucket)
                is_free = is_free && (points[p] - x).norm() >= radius;
        });
        return is_free;
    }

    void add(const Vec3& x)
    {
        buckets_[cell(x.x()) + cells_ * (cell(x.y()) + cells_ * cell(x.z()))].push_back(
            static_cast<int>(points.size()));
        points.push_back(x);
        size_at.push_back(wanted(x));
    }

    double size_, gradation_;
    int cells_;
    Random random_;
    cleft::Array<cleft::Array<int>> buckets_;
};

}  // namespace cleft_test
