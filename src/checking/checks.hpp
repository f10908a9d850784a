// The parts of a validation: what is wrong with the points, the tetrahedra and the faces of a mesh, and where first.
#pragma once

#include "base/placement.hpp"
#include "base/run.hpp"
#include "mesh/bounding_box.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// How often something was met, and where first.
struct Tally {
    int64_t count = 0;
    int64_t first = -1;

    void add(int64_t where)
    {
        if (count++ == 0)
            first = where;
    }
    // What `later` met lies behind all that was met here.
    void append(const Tally& later)
    {
        if (count == 0)
            first = later.first;
        count += later.count;
    }
};

struct PointChecks {
    BoundingBox box;  // of the used finite points
    Tally non_finite, unused;
    Tally repeated;            // used points at the place of another one
    int64_t repeated_of = -1;  // that other one, for the first
};

PointChecks check_points(const RegionMesh& mesh);

// The exact orientation of a tetrahedron; unknown if a point is not there or not finite.
enum class Sign : int8_t { negative = -1, flat = 0, positive = 1, unknown = 2 };

struct TetChecks {
    std::vector<Sign> sign;  // of each tetrahedron
    Tally bad_index, repeated_corner, negative, flat;
    double volume = 0;  // sum of signed volumes
};

TetChecks check_tets(const RegionMesh& mesh, const Run& run);

// Places are half-faces (see HalfFace::id); that of an open edge is its least point * 2^32 + the other.
struct FaceChecks {
    Tally hull, shared, crowded, folded, off_box;
    Tally interfaces;
    Tally open_edges;
    double hull_area = 0;
};

// The area is told in the world.
FaceChecks check_faces(const RegionMesh& mesh, const BoundingBox& box, const std::vector<Sign>& sign,
                       const Placement& world, const Run& run);

}  // namespace cleft
