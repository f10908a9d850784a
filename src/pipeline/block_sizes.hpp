// The sizes of a volume, block by block: those of a block follow from the planes of voxels around it.
#pragma once

#include "parts/exchange.hpp"
#include "pipeline/block_layout.hpp"
#include "pipeline/pipeline.hpp"

namespace cleft
{

// Of this rank's blocks. A size is at most a quarter of the thickness of a block: tetrahedra are small beside it then,
// and nothing that is farther away than the thickness has a say. max_tets is kept to by all ranks together.
SizingField sizes_of_own_blocks(const VolumeParts& volume, const BlockLayout& layout, const PipelineOptions& options,
                                Exchange& exchange, const Run& run);

// The planes that each rank wants, from those that each has.
SizingField swapped_planes(const SizingField& own, Planes wanted, Exchange& exchange);

// Of the whole field.
SizeRange range_of_all(const SizingField& own, Exchange& exchange);

}  // namespace cleft
