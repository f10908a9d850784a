// The surface of the tetrahedra that are shown: all that a picture can show of them.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "io/mesh_view.hpp"

#include <cstdint>

namespace cleft::io
{

// A face of one tetrahedron that is shown and of no other.
struct OuterFace {
    int32_t corners[3];  // ascending
    int32_t inner;       // the fourth corner of the tetrahedron
    int32_t tet;
};

// In an order that depends on the mesh alone. Faces of more than two tetrahedra, which no sound mesh has, are there
// too.
Array<OuterFace> outer_faces(const MeshView& mesh, const Array<char>& is_shown, const Run& run);

}  // namespace cleft::io
