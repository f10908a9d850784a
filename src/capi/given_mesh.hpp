// Meshes that users give to be worked on, checked whole: the stages build on sound ones.
#pragma once

#include "base/run.hpp"
#include "capi/handles.hpp"

namespace cleft::capi
{

// An Error with the first fault, CLEFT_ERROR_INVALID_MESH, unless the mesh is conforming and positively oriented.
// `whose` is what it is called: "background". Points that are in no tetrahedron are no fault.
void require_valid(const cleft_mesh& mesh, const char* whose, const Run& run);

// A user's background in the frame of a volume, without the points that it does not use. Refuses what is not valid,
// overlaps, or lies outside of the volume's box; warns where it does not fill the box, or reaches out of it.
TetMesh checked_background(const cleft_mesh& mesh, const Frame& frame, const Run& run);

}  // namespace cleft::capi
