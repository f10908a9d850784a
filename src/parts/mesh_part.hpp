// The part of a mesh that one rank has.
#pragma once

#include "mesh/bounding_box.hpp"
#include "mesh/interfaces.hpp"
#include "mesh/user_label.hpp"
#include "parts/exchange.hpp"
#include "parts/mesh_pieces.hpp"

namespace cleft
{

// What a rank has of something, and where its own begins among that of all ranks.
struct Share {
    int64_t owned = 0;
    int64_t first = 0;
    int64_t all = 0;
};

struct PartTriangle {
    Triangle corners;
    std::array<int32_t, 2> regions;  // the lesser one first; one twice at the hull
    int32_t side;                    // of the hull, a Side; -1: of an interface
};

// Points and tetrahedra of this rank come before those of others, each in the order of their numbers.
struct MeshPart {
    Array<Vec3> points;
    Array<int64_t> numbers;  // of points, in the whole mesh
    Array<int32_t> owners;   // of points
    Share of_points;
    Array<Tet> tets;
    Array<Material> material;
    Array<int64_t> tet_numbers;  // in the whole mesh
    Array<int32_t> tet_owners;
    Share of_tets;
    // Each in the part of one rank: the owner of its tetrahedron, or of the one of lower number. Sorted by side,
    // regions and corners.
    Array<PartTriangle> triangles;
    Share of_triangles;
};

// CLEFT_ERROR_TOO_LARGE if numbers of 32 bits are too few for a part.
void check_size_of_part(int64_t points, int64_t tets);

// Gives each rank its part of a mesh that ranks have in pieces, and empties these. A rank may have none. `labels`: of
// the materials of the pieces; parts have them as numbers in the place of materials. `box`: that of the volume. With
// `ghosts`, a part has all tetrahedra at its own points. With a scratch folder, what arrives is in a file until the
// part is made of it.
MeshPart share_mesh(const MeshPieces& pieces, const Array<UserLabel>& labels, const BoundingBox& box, bool ghosts,
                    Exchange& exchange, const Run& run);

}  // namespace cleft
