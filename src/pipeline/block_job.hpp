// Work on blocks of a mesh and on the seams between two of them: pure functions of these and of the volume around them.
#pragma once

#include "cleaving/snapped.hpp"
#include "pipeline/pipeline.hpp"

#include <functional>

namespace cleft
{

struct Block {
    TetMesh background;
    Array<int32_t> held;  // vertices where it was cut out of the whole background
    Snapped snapped;
    LabelledMesh mesh;
};

// A part of a background. Points of all parts must be in the order of their places, since cuts run from the lower end
// of an edge to the higher one.
Block block_of(TetMesh background, const BoundingBox& box, const Run& run);

// Snaps the vertices that are not held.
void snap_block(const Volume& volume, Block& block, const PipelineOptions& options, const Run& run);
// Snaps those that two blocks share, and once more those near them.
void snap_seam(const Volume& volume, Block& lower, Block& upper, const PipelineOptions& options, const Run& run);

// Makes the mesh of a block in which all vertices have snapped. It is the same on both sides of a seam.
void mesh_block(const Volume& volume, Block& block, const PipelineOptions& options, const Run& run);

// Improves where two blocks meet. Afterwards tetrahedra near the seam belong to the upper block if they are above.
using IsAbove = std::function<bool(const Array<Vec3>& points, const Tet& tet)>;
void improve_seam(const Volume& volume, LabelledMesh& lower, LabelledMesh& upper, const IsAbove& is_above,
                  const PipelineOptions& options, const Run& run);

}  // namespace cleft
