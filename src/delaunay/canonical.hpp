// One way to write a tetrahedron, and one order of them.
#pragma once

#include "mesh/tet_mesh.hpp"

namespace cleft
{

// The least corner first, the least of the others second; an even permutation, so that the orientation stays.
//   Branches on what is least would be guessed wrongly by most processors.
inline Tet canonical(const Tet& tet)
{
    const int first = tet[1] < tet[0], second = 2 + (tet[3] < tet[2]);
    const int least = tet[second] < tet[first] ? second : first;
    // Each of these permutations swaps two pairs.
    const int32_t a = tet[least ^ 1], b = tet[least ^ 2], c = tet[least ^ 3];
    constexpr int kTurned[] = {0, 1, 2, 0, 1};
    const FixedArray<int32_t, 3> others{{a, b, c}};
    const int next = b < a ? (c < b ? 2 : 1) : (c < a ? 2 : 0);
    return {{tet[least], others[next], others[kTurned[next + 1]], others[kTurned[next + 2]]}};
}

}  // namespace cleft
