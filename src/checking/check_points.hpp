// What is wrong with the points of a mesh, and where first.
#pragma once

#include "checking/tally.hpp"
#include "mesh/bounding_box.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

struct PointChecks {
    BoundingBox box;  // of the used finite points
    Tally non_finite, unused;
    Tally repeated;            // used points at the place of another one
    int64_t repeated_of = -1;  // that other one, for the first
};

// Runs on one thread, and takes 16 bytes per point in use while it runs.
PointChecks check_points(const RegionMesh& mesh);

}  // namespace cleft
