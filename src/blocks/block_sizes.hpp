// The sizes of a volume, block by block: those of a block follow from the planes of voxels around it.
#pragma once

#include "blocks/block_layout.hpp"
#include "finishing/pipeline_options.hpp"
#include "parts/exchange.hpp"
#include "parts/kept_bytes.hpp"

namespace cleft
{

// The sizes of planes, block after block, in memory or on disk.
class BlockField
{
public:
    // `scratch`: the folder; empty: in memory.
    BlockField(const Grid& whole, double gradation, const std::string& scratch);

    void clear();
    // The next planes of the whole.
    void add(Planes planes, const Array<float>& h);
    // Of the planes that are here.
    SizeRange range() const { return range_; }
    Array<float> values(Planes planes) const;
    Planes planes() const;

    const Grid& grid() const { return grid_; }
    double gradation() const { return gradation_; }

    // The tetrahedra that the sizes ask for, by block: of all blocks.
    void expect(Array<double>&& tets) { tets_ = std::move(tets); }
    const Array<double>& expected_tets() const { return tets_; }

private:
    Grid grid_;
    double gradation_;
    SizeRange range_;
    Array<Planes> slabs_;
    Array<double> tets_;
    KeptBytes sizes_;  // by slab
};

// Of this rank's blocks. A size is at most a quarter of the thickness of a block: tetrahedra are small beside it then,
// and nothing that is farther away than the thickness has a say. max_tets is kept to by all ranks together.
BlockField sizes_of_own_blocks(const VolumeParts& volume, const BlockLayout& layout, const PipelineOptions& options,
                               Exchange& exchange, const Run& run);

// The planes that each rank wants, from those that each has.
SizingField swapped_planes(const BlockField& own, Planes wanted, Exchange& exchange);

// Of the whole field.
SizeRange range_of_all(const SizeRange& own, Exchange& exchange);

}  // namespace cleft
