// What is wrong with the faces of a mesh, and where first.
#pragma once

#include "base/array.hpp"
#include "base/placement.hpp"
#include "checking/check_tets.hpp"
#include "mesh/bounding_box.hpp"

namespace cleft
{

// Places are half-faces (see HalfFace::id); that of an open edge is its least point * 2^32 + the other.
struct FaceChecks {
    Tally hull, shared, crowded, folded, off_box;
    Tally interfaces;
    Tally open_edges;
    double hull_area = 0;
};

// The area is that in the world.
// The terms are those of Validation (validate.hpp). `sign` has one entry per tetrahedron. Memory for the interfaces and
// the faults comes on top of FaceBuckets.
FaceChecks check_faces(const RegionMesh& mesh, const BoundingBox& box, const Array<Sign>& sign, const Placement& world,
                       const Run& run);

}  // namespace cleft
