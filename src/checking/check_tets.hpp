// What is wrong with the tetrahedra of a mesh, and where first.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "checking/tally.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// The exact orientation of a tetrahedron; unknown if a point is not there or not finite.
enum class Sign : int8_t { negative = -1, flat = 0, positive = 1, unknown = 2 };

struct TetChecks {
    // Kept for check_faces(), which needs to know on which side of a face a tetrahedron lies.
    Array<Sign> sign;  // of each tetrahedron
    Tally bad_index, repeated_corner, negative, flat;
    double volume = 0;  // sum of signed volumes
};

// Points may be anything. No check stops the others, so that one bad index does not hide an inverted tetrahedron.
TetChecks check_tets(const RegionMesh& mesh, const Run& run);

}  // namespace cleft
