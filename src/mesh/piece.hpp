// Pieces of a mesh: taken out of it, and put together again.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "mesh/bounding_box.hpp"
#include "mesh/tet_mesh.hpp"

#include <functional>

namespace cleft
{

// The tetrahedra of a mesh for which `is_in` holds, with their points. Points and tetrahedra keep their order, so what
// stages decide by number comes out as in the whole.
LabelledMesh piece_of(const LabelledMesh& mesh, const std::function<bool(int64_t tet)>& is_in);
TetMesh piece_of(const TetMesh& mesh, const std::function<bool(int64_t tet)>& is_in);

// Whether one place comes before another: by z, then by y, then by x.
bool is_lower_place(const Vec3& x, const Vec3& y);
// The same mesh with its points in that order, and its tetrahedra in the order of their points: no cut into pieces
// changes either.
TetMesh ordered_by_place(const TetMesh& mesh);

// Of some points, by their numbers.
Array<Vec3> places_of(const Array<Vec3>& points, const Array<int32_t>& some);
// Of `candidates`, the points at one of the places.
Array<int32_t> points_at(const Array<Vec3>& points, const Array<int32_t>& candidates, const Array<Vec3>& places);
// By tetrahedron: 1 if it is within some rings of the points.
Array<uint8_t> near_points(const Array<Tet>& tets, size_t point_count, const Array<int32_t>& points, int rings);

// Two pieces as one mesh: points of their hulls that have the same coordinates are one point.
LabelledMesh joined(LabelledMesh a, const LabelledMesh& b, const Run& run);

// The corners of hull triangles that lie in no side of the box, ascending: where a piece was cut out of a mesh.
Array<int32_t> points_of_cut(const RegionMesh& piece, const BoundingBox& box, const Run& run);
Array<int32_t> points_of_cut(const TetMesh& piece, const BoundingBox& box, const Run& run);

}  // namespace cleft
