// The triangles of a mesh between two materials, and its edges where three meet.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"
#include "volume/tie_points.hpp"

namespace cleft
{

// An edge has its second corner as its third, too: it is a triangle without area.
struct TieElement {
    TieMaterials of;
    FixedArray<int32_t, 3> corner;
};

// Interfaces first, each together. An edge where more than three materials meet belongs to every three of them.
// A face of more than two tetrahedra is an Error (CLEFT_ERROR_INVALID_MESH).
Array<TieElement> tie_elements(const LabelledMesh& mesh, const Run& run);

// The distance from x to the nearest point of the element, squared.
double square_distance(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace cleft
