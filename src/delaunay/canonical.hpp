// One way to write a tetrahedron, and one order of them.
#pragma once

#include "mesh/tet_mesh.hpp"

#include <algorithm>

namespace cleft
{

// The least corner first, the least of the others second; an even permutation, so that the orientation stays.
inline Tet canonical(Tet tet)
{
    const auto least = std::min_element(tet.begin(), tet.end()) - tet.begin();
    if (least != 0) {
        std::swap(tet[0], tet[least]);
        std::swap(tet[least == 1 ? 2 : 1], tet[least == 3 ? 2 : 3]);
    }
    std::rotate(tet.begin() + 1, std::min_element(tet.begin() + 1, tet.end()), tet.end());
    return tet;
}

}  // namespace cleft
