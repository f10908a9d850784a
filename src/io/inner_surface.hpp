// The triangles inside the box as a surface of its own, for formats that hold nothing else.
#pragma once

#include "io/mesh_view.hpp"

#include <vector>

// Binary formats are written as the machine keeps its numbers.
static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "binary files are little-endian");

namespace cleft::io
{

struct InnerSurface {
    std::vector<int32_t> points;     // numbers of the mesh's points that are used, ascending
    std::vector<int32_t> triangles;  // three a triangle, numbering the mesh's points
    std::vector<int32_t> corners;    // three a triangle, numbering `points`
    std::vector<int32_t> labels;     // two a triangle; twice the same on the hull

    int64_t count() const { return static_cast<int64_t>(triangles.size() / 3); }
};

// All arrays are copies. Throws std::bad_alloc only.
InnerSurface inner_surface(const MeshView& mesh);

}  // namespace cleft::io
