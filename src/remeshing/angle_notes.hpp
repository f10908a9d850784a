// The dihedral angles of a mesh as notes of a stage that changes them.
#pragma once

#include "base/run.hpp"
#include "remeshing/local_mesh.hpp"

namespace cleft
{

// Notes PREFIX.{tets, min_angle, max_angle, below_10, below_15, below_20, below_25, below_30}_WHEN: angles in degrees,
// tetrahedra by their least angle. Does nothing if nobody wants notes.
void note_angles(const LocalMesh& mesh, const std::string& prefix, const std::string& when, const Run& run);

}  // namespace cleft
