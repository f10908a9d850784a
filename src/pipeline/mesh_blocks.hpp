// A mesh made block by block. Blocks are slabs of the volume across its last axis, of the same thickness everywhere:
// which slab a tetrahedron of the background is in follows from its place, never from threads, ranks or memory.
//
// 1. In each block, vertices snap that are not where it was cut out of the background. Then those at each seam do,
//    with the tetrahedra of both blocks around them.
// 2. Each block is cut, improved and fitted on its own. Its surface inside the volume stays as it is. Cuts follow from
// their
//    edges, so the blocks fit together.
// 3. At each seam, the tetrahedra near it from both blocks are improved and fitted together, and their outside stays as
//    it is. Seams of even number come first, then the others, so that none touches another.
#pragma once

#include "pipeline/pipeline.hpp"

namespace cleft
{

// How many blocks of so many planes of voxels a volume has; 1 for 0 planes.
int32_t block_count(const Grid& grid, int32_t planes);

// Cleaving, improving and fitting of a whole background, block by block.
LabelledMesh mesh_in_blocks(const Volume& volume, const TetMesh& background, const PipelineOptions& options,
                            const Run& run);

}  // namespace cleft
