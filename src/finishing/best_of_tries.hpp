// Improving a cleaved mesh, in several tries if need be.
#pragma once

#include "finishing/improve_and_fit.hpp"
#include "remeshing/local_mesh.hpp"

namespace cleft
{

struct Improved {
    LocalMesh mesh;
    bool holds_surfaces;  // its triangles are within the surface error, but for single ones
};

// The improved mesh. Where few tetrahedra of a small mesh stay short of the target angle, other tries are made and
// the best one is taken. Notes improving.* of the try that is taken, and improving.tries.
Improved best_of_tries(const Volume& volume, const Cleaved& cleaved, const PipelineOptions& options, const Run& run);

}  // namespace cleft
