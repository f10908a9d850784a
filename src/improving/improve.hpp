// Improving: raises the least dihedral angles of a cleaved mesh; interfaces, triple lines and the box stay.
#pragma once

#include "base/run.hpp"
#include "mesh/local_mesh.hpp"
#include "volume/volume.hpp"

namespace cleft
{

enum class Effort { off, fast, best };

struct ImproveOptions {
    Effort effort = Effort::fast;
    double target_angle = 20;  // degrees
};

// Never inverts a tetrahedron, never changes which materials touch. Notes improving.*.
void improve(LocalMesh& mesh, const Volume& volume, const ImproveOptions& options, const Run& run);
void improve(LabelledMesh& mesh, const Volume& volume, const ImproveOptions& options, const Run& run);

}  // namespace cleft
