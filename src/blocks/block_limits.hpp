// The sizes that the curvatures of a volume allow, found block by block: once for each plane, though the sizes of
// several blocks depend on it.
#pragma once

#include "blocks/block_layout.hpp"
#include "parts/exchange.hpp"
#include "sizing/compute.hpp"

namespace cleft
{

class BlockLimits
{
public:
    // All ranks call it together. Each finds those of its blocks, and gets those of all planes that it wants.
    // `error`: of surfaces; 0: there are no limits.
    BlockLimits(const VolumeParts& volume, const BlockLayout& layout, double error, Planes wanted, Exchange& exchange,
                const Run& run);

    // Of these planes, with numbers of voxels that count from the first of these. They must be among those wanted.
    Array<SizeLimit> in(Planes planes) const;

private:
    int64_t plane_size_;
    Array<SizeLimit> limits_;  // ascending by voxel of the whole
};

}  // namespace cleft
