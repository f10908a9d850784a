// Point sets in general position, of many kinds, in the unit box.
#pragma once

#include "background/point_sets.hpp"

namespace cleft_test
{

inline Array<Vec3> random_cloud(Random& random, int count)
{
    Array<Vec3> points;
    for (int i = 0; i < count; ++i)
        points.push_back(random_in_box(random, Vec3(1, 1, 1)));
    return points;
}

// Around some places, at distances of very different sizes.
inline Array<Vec3> random_clusters(Random& random, int count)
{
    Array<Vec3> points = random_cloud(random, std::max(2, count / 20));
    const auto centres = points.count();
    while (points.count() < count) {
        const Vec3 offset = random_in_box(random, Vec3(1, 1, 1)) - Vec3(0.5, 0.5, 0.5);
        points.push_back(points[random.below(static_cast<uint64_t>(centres))] +
                         offset * std::pow(10, random.between(-6, -1)));
    }
    return points;
}

// A lattice as the seeds have it: a jitter of 1e-9 to 0.3 cells, none across the walls.
inline Array<Vec3> jittered_lattice(Random& random, int count)
{
    const int n = std::max(2, static_cast<int>(std::cbrt(count / 2)));  // the corners of one cell are on a sphere
    Array<Vec3> points = bcc_lattice(n, std::pow(10, random.between(-9, -0.5)), random.bits());
    for (Vec3& p : points)
        p /= n;
    return points;
}

// As thin as a millionth of the box.
inline Array<Vec3> near_plane(Random& random, int count)
{
    Array<Vec3> points = random_cloud(random, count);
    const double thickness = std::pow(10, random.between(-6, -1));
    for (Vec3& p : points)
        p.z() *= thickness;
    return points;
}

inline Array<Vec3> graded_points(Random& random, int count)
{
    const double size = 0.8 / std::cbrt(count);
    return PoissonPoints(size, random.between(0, 0.3), random.bits()).points;
}

inline Array<Vec3> random_set(int kind, int count, uint64_t seed)
{
    Random random(seed);
    switch (kind % 5) {
        case 0:
            return random_cloud(random, count);
        case 1:
            return random_clusters(random, count);
        case 2:
            return jittered_lattice(random, count);
        case 3:
            return near_plane(random, count);
        default:
            return graded_points(random, count);
    }
}

}  // namespace cleft_test
