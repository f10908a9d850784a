// Particles of blocks. Each block is a box of its own, and where two blocks meet, both have the same particles on the
// plane between them. So what a block gets follows from the sizes in it and in its neighbours (decision 30).
#pragma once

#include "background/particles.hpp"
#include "blocks/block_sizes.hpp"
#include "blocks/mesh_blocks.hpp"

namespace cleft
{

// Whether blocks are thick enough. In others, tetrahedra between the two walls would be flat.
bool have_room_for_particles(const BlockLayout& layout, const SizeRange& sizes);

// The backgrounds of this rank's blocks. Blocks of even number are relaxed here, as boxes with walls of their own; the
// others later, when they are asked for, with the particles that their neighbours have on these walls.
// All ranks call it together; `sizes`, `layout` and `exchange` must outlive what is returned.
BackgroundOfBlock particles_of_blocks(const BlockField& sizes, const BlockLayout& layout, const BlockShares& shares,
                                      const ParticleOptions& options, Exchange& exchange, const Run& run);

// All of them as one background, in one process.
TetMesh particles_in_blocks(const SizingField& sizes, const BlockLayout& layout, const ParticleOptions& options,
                            const Run& run);

}  // namespace cleft
