// What is told of a mesh when it is done.
#pragma once

#include "finishing/missed_goal.hpp"
#include "finishing/volume_differences.hpp"

namespace cleft
{

int64_t kept_tets(const LabelledMesh& mesh, const KeptMaterials& kept);

// Refuses a mesh without any tetrahedron that is kept: a label that is to be kept can have been lost, and where all
// are, an empty mesh would be left.
void require_kept(int64_t kept_tets);

}  // namespace cleft
