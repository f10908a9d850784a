// A mesh made block by block. Which block a tetrahedron of the background is in follows from its place, never from
// threads, ranks or memory.
//
// 1. In each block, vertices snap that are not where it was cut out of the background. Then those at each seam do,
//    with the tetrahedra of both blocks around them.
// 2. Each block is cut, improved and fitted on its own. Its surface inside the volume stays as it is. Cuts follow from
//    their edges, so the blocks fit together.
// 3. At each seam, the tetrahedra near it from both blocks are improved and fitted together, and their outside stays as
//    it is.
#pragma once

#include "blocks/block_layout.hpp"
#include "blocks/block_shares.hpp"
#include "finishing/improve_and_fit.hpp"
#include "parts/exchange.hpp"
#include "parts/mesh_pieces.hpp"

namespace cleft
{

// The tetrahedra of a background whose middles are in a block.
TetMesh part_in_block(const TetMesh& background, const BlockLayout& layout, int32_t block);
// Makes them. All ranks call it together and equally often; -1 stands for no block.
using BackgroundOfBlock = std::function<TetMesh(int32_t block, const Run& run)>;

// The mesh of this rank's blocks, each of them a piece. With a scratch folder, two of them are in memory at a time.
MeshPieces mesh_own_blocks(const VolumeParts& volume, const BlockLayout& layout, const BlockShares& shares,
                           const BackgroundOfBlock& background, const PipelineOptions& options, Exchange& exchange,
                           const Run& run);

// Cleaving, improving and fitting of a whole background, block by block, in one process.
LabelledMesh mesh_in_blocks(const Volume& volume, const TetMesh& background, const PipelineOptions& options,
                            const Run& run);

// A volume that is there as a whole. It must outlive what is returned.
VolumeParts parts_of(const Volume& whole);

}  // namespace cleft
