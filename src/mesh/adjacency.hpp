// Which tetrahedra share a face.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// Corners of the face opposite corner i, wound so that it looks outward from a positive tetrahedron.
inline constexpr int kFaceCorners[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
// The six edges, and the two corners opposite each.
inline constexpr int kEdgeCorners[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
inline constexpr int kEdgeOpposite[6][2] = {{2, 3}, {1, 3}, {1, 2}, {0, 3}, {0, 2}, {0, 1}};

// neighbour[t][i]: the tetrahedron behind the face opposite corner i of t; -1 on the hull.
// Linear time, threaded. A face of more than two tetrahedra is an Error (CLEFT_ERROR_INVALID_MESH).
Array<FixedArray<int32_t, 4>> tet_neighbours(const Array<Tet>& tets, int64_t point_count, const Run& run = Run());

// Bits 0, 1, 2 of a point: its x, y, z must not change if the hull is to stay as it is. A hull face across an axis
// (all three points have exactly the same coordinate) freezes that coordinate; any other hull face freezes all.
Array<uint8_t> frozen_axes(const Array<Vec3>& points, const Array<Tet>& tets,
                           const Array<FixedArray<int32_t, 4>>& neighbours);

// The axes that one hull face freezes.
unsigned hull_axes(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace cleft
