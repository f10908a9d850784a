// The backgrounds of a rank's blocks, from the sizes that ranks have of theirs.
#pragma once

#include "blocks/block_sizes.hpp"
#include "blocks/mesh_blocks.hpp"
#include "parts/exchange.hpp"

namespace cleft
{

// Of the kind that the options name. All ranks call it together; `sizes`, `layout` and `exchange` must outlive what is
// returned.
// A rank makes an octree or a lattice around each of its blocks, or particles in them. Where blocks are too thin for
// these, the first rank makes them from all sizes, and each rank gets the tetrahedra of its blocks.
BackgroundOfBlock backgrounds_of_rank(const BlockField& sizes, const BlockLayout& layout, const BlockShares& shares,
                                      const BackgroundOptions& options, Exchange& exchange, const Run& run);

}  // namespace cleft
