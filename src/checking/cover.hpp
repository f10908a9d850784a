// How a background lies in the box that it is to fill.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

struct Cover {
    bool is_outside = false;   // no part of its bounding box is within the box
    bool reaches_out = false;  // some of it is not
    // Of its bounding box, the volume of its tetrahedra. Tetrahedra that overlap without sharing faces show themselves
    // by it: more than 1.
    double share_of_its_box = 0;
    bool overlaps = false;
    // Of the box.
    double share_of_box = 0;
    bool fills_box = false;
};

// In the frame of the box, one corner of which is at the origin. The mesh is valid and has tetrahedra.
Cover cover_of(const TetMesh& mesh, const Vec3& extent, const Run& run);

}  // namespace cleft
