// The mesh of a volume that no rank has as a whole: each makes the blocks of its planes.
#pragma once

#include "finishing/pipeline_options.hpp"
#include "parts/exchange.hpp"
#include "parts/mesh_pieces.hpp"
#include "parts/voxel_source.hpp"

namespace cleft
{

// A label map that all ranks can read.
struct SharedVoxels {
    Grid grid;
    VoxelSource source;
};

// Its labels in the order in which the voxels come, and their numbers. Each rank reads the planes of its blocks.
LabelCounts labels_of_all(const SharedVoxels& voxels, int32_t block, Exchange& exchange, const Run& run);

// This rank's pieces of the mesh, without the materials that are not kept. The pieces of all ranks together are what
// mesh_from_volume() makes of the whole volume with the same options, of which `block` must be above 0.
// `smooth`: the width of the kernel.
MeshPieces mesh_of_rank(const SharedVoxels& voxels, const LabelCounts& labels, int smooth,
                        const PipelineOptions& options, Exchange& exchange, const Run& run);

// Why the whole mesh must be made in one place, in words; empty: it need not be.
std::string needs_whole_mesh(const PipelineOptions& options, const Grid& grid);

}  // namespace cleft
