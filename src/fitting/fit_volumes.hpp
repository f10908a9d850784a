// Fitting of volumes: pays back what flat triangles cut off curved interfaces.
#pragma once

#include "base/run.hpp"
#include "remeshing/local_mesh.hpp"
#include "volume/volume.hpp"

namespace cleft
{

// A triangle whose corners lie on a curved interface is a chord: the convex side loses volume, by some
// 3 h^2 / (8 R^2) of it with edges h on a sphere of radius R. Moves the points of interfaces, and of lines where
// interfaces meet, along the normals (not off the walls), so that the corners of each triangle give back its share of
// the loss. No tetrahedron gets worse than `least_angle` degrees (or than the worst around already is). Notes
// fitting.*. Returns whether the volumes of all labels, but small ones, are met within a few percent.
//   With a `surface_error`, no point moves by more than half of it, since points are off the interface then as well as
// triangles.
//   `volumes`: what each material of a label map is to have; null: the volume of its voxels.
bool fit_volumes(LocalMesh& mesh, const Volume& volume, double least_angle, const Run& run, double surface_error = 0,
                 const Array<double>* volumes = nullptr);
bool fit_volumes(LabelledMesh& mesh, const Volume& volume, double least_angle, const Run& run);

}  // namespace cleft
