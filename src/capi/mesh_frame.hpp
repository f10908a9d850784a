// Between the meshes of the stages (local frame, dense materials) and those of the user (world, labels).
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "capi/handles.hpp"

#include <string>

namespace cleft::capi
{

// Points in world coordinates; an affine that mirrors turns the tetrahedra round. What the user gets is checked
// (quick_fault()): an Error if a stage went wrong, or if the numbers of the world, far from the origin, do not tell the
// points apart.
Array<Vec3> to_world(const Array<Vec3>& local, Array<Tet>& tets, const Frame& frame, const Run& run);
// The latter, of a fault that the points did not have before.
[[noreturn]] void refuse_coarse_world(const std::string& fault);
// World coordinates and labels for a stage's result.
cleft_mesh to_user(LabelledMesh&& mesh, const Frame& frame, const Array<UserLabel>& labels, const Run& run);
// The same of a stage that another goes on from: that gets the very points, not those that rounding to the world
// leaves.
cleft_mesh to_next_stage(LabelledMesh&& mesh, MadeBy stage, const Frame& frame, const Array<UserLabel>& labels,
                         const Run& run);
// Whether the mesh is as that stage left it, in this frame.
// A mesh that the caller has made of arrays, or stripped, never is: its points may have changed.
bool is_as_left(const cleft_mesh& mesh, MadeBy stage, const Frame& frame);
// Its points and tetrahedra, then.
TetMesh as_left(const cleft_mesh& mesh, const Run& run);

// The points and tetrahedra of a user-supplied mesh in the local frame of a volume.
void to_local(const cleft_mesh& mesh, const Frame& frame, Array<Vec3>& points, Array<Tet>& tets, const Run& run);

// The same with labels turned into the volume's materials; a label that the volume lacks is an Error.
LabelledMesh to_stage(const cleft_mesh& mesh, const cleft_volume& volume, const Run& run);

// A mirrored tetrahedron is negative: this makes positive ones of them. Callers rely on positive ones, and so do the
// stages.
void turn_round(Array<Tet>& tets, const Run& run);

// The different labels of a mesh, ascending.
Array<int32_t> distinct_labels(const Array<int32_t>& tet_labels, const Run& run);

}  // namespace cleft::capi
