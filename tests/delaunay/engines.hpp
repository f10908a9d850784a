// The engines of Delaunay meshes, as the tests call them, and what holds of each result.
#pragma once

#include "base/error.hpp"
#include "delaunay/brick_delaunay.hpp"
#include "delaunay/delaunay.hpp"
#include "delaunay/perturbed.hpp"
#include "delaunay/widest_tet.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/predicates.hpp"

#include <algorithm>

namespace cleft_test
{

using cleft::Array;
using cleft::DelaunayEngine;
using cleft::Tet;
using cleft::Vec3;

inline bool has_tetgen()
{
    static const bool has = [] {
        try {
            delaunay({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}, DelaunayEngine::tetgen,
                     cleft::Run{});
            return true;
        } catch (const cleft::Error&) {
            return false;
        }
    }();
    return has;
}

// Points in the box [-2, 2], in bricks of any size.
inline Array<Tet> in_bricks(const Array<Vec3>& points, int64_t points_in_brick, int threads = 1)
{
    cleft::Run run;
    run.threads = threads;
    return cleft::brick_delaunay(points, cleft::widest_tet(points).value(), points_in_brick, run);
}

// Positive tetrahedra that use all points, share their faces, have no neighbour's point inside their spheres, and end
// in faces beyond which no point is: the Delaunay mesh.
inline bool is_delaunay(const Array<Vec3>& points, const Array<Tet>& tets)
{
    const auto neighbours = cleft::tet_neighbours(tets, points.count());
    Array<char> used(points.size(), 0);
    for (size_t t = 0; t < tets.size(); ++t) {
        const auto corner = [&](int i) -> const Vec3& { return points[tets[t][i]]; };
        if (cleft::orient_sign(corner(0), corner(1), corner(2), corner(3)) <= 0)
            return false;
        for (int face = 0; face < 4; ++face) {
            used[tets[t][face]] = 1;
            const auto& f = cleft::kFaceCorners[face];
            const int32_t next = neighbours[t][face];
            if (next < 0) {
                for (const Vec3& p : points)
                    if (cleft::orient_sign(corner(f[0]), corner(f[1]), corner(f[2]), p) > 0)
                        return false;
            } else {
                for (const int32_t v : tets[next])
                    if (!cleft::has_corner(tets[t], v) &&
                        cleft::in_sphere_sign(corner(0), corner(1), corner(2), corner(3), points[v]) > 0)
                        return false;
            }
        }
    }
    return std::count(used.begin(), used.end(), 0) == 0;
}

}  // namespace cleft_test
