// Which face of which tetrahedron each surface triangle is.
#pragma once

#include "io/mesh_view.hpp"

#include <vector>

namespace cleft::io
{

struct ElementFace {
    int64_t tet = -1;
    int32_t face = -1;  // 0 .. 3 for the corners 012, 013, 123, 023: Abaqus's S1 .. S4
};

// For each triangle of each group the face of the tetrahedron whose label is the group's first. Throws if there is
// none, which no mesh of this library does.
std::vector<std::vector<ElementFace>> find_element_faces(const MeshView& mesh);

}  // namespace cleft::io
