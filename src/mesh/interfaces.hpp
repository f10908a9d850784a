// The triangles where regions meet and where the mesh ends.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

using Triangle = std::array<int32_t, 3>;

// Sides of the box; `other` is a hull triangle in no box side (a user's background, or a stripped material).
enum class Side : int32_t { x_min = 0, x_max = 1, y_min = 2, y_max = 3, z_min = 4, z_max = 5, other = 6 };

struct Interfaces {
    // Between two regions: corners wound so that the normal points from the first region to the second; first <
    // second. Sorted by pair, then by corners.
    Array<Triangle> triangles;
    Array<std::array<int32_t, 2>> pairs;
    Array<std::array<int32_t, 2>> tets;  // of the two regions
    // Hull: wound outward, with the region inside. Sorted by side, then region, then corners.
    Array<Triangle> hull;
    Array<int32_t> hull_region;
    Array<Side> hull_side;
    Array<int32_t> hull_tet;
};

// lo, hi: the box against which sides are decided, by exact coordinates.
// A face of more than two tetrahedra is an Error (CLEFT_ERROR_INVALID_MESH), because it has no two sides.
Interfaces extract_interfaces(const RegionMesh& mesh, const Vec3& lo, const Vec3& hi, const Run& run);

}  // namespace cleft
