// The numbering of a finished mesh.
#pragma once

#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// The even permutation of the corners that puts the least number first and the next one second. It keeps the
// orientation. The first corner then decides the place of the tetrahedron among the others.
template <class Number>
FixedArray<Number, 4> least_corners_first(FixedArray<Number, 4> t)
{
    const auto swap_two_pairs = [&](int64_t a, int64_t b, int64_t c, int64_t d) {
        std::swap(t[a], t[b]);
        std::swap(t[c], t[d]);
    };
    const auto least = std::min_element(t.begin(), t.end()) - t.begin();
    if (least > 0)
        swap_two_pairs(0, least, least == 1 ? 2 : 1, least == 3 ? 2 : 3);
    std::rotate(t.begin() + 1, std::min_element(t.begin() + 1, t.end()), t.end());
    return t;
}

// Renumbers points and tetrahedra along a Hilbert curve, for solvers; drops unused points.
// A matrix over points that are near each other in memory has its entries near the diagonal. The numbers before matter
// only for points at one place.
void order_spatially(LabelledMesh& mesh, const Run& run);

}  // namespace cleft
