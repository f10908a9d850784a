// What a rank needs of the sizes differs with the kind: planes around a block, their range, or all of them.
#include "blocks/rank_backgrounds.hpp"

#include "background/kinds.hpp"
#include "background/lattice.hpp"
#include "background/octree.hpp"
#include "base/quiet_run.hpp"
#include "base/stage.hpp"
#include "blocks/block_parcels.hpp"
#include "blocks/block_particles.hpp"
#include "volume/frame.hpp"

namespace cleft
{

namespace
{

// Of the octree, what is around a block.
BackgroundOfBlock octree_of(const BlockField& sizes, const BlockLayout& layout, Exchange& exchange)
{
    const SizeRange range = range_of_all(sizes.range(), exchange);
    return [&, range](int32_t block, const Run& run) {
        const double low = layout.start(block), high = layout.start(block + 1);
        const Planes planes = block < 0 ? Planes{} : octree_slab_planes(layout.grid, range, low, high);
        const SizingField around = swapped_planes(sizes, planes, exchange);
        return block < 0 ? TetMesh() : part_in_block(octree_slab(around, range, low, high, run), layout, block);
    };
}

// A lattice needs the range of all sizes alone.
BackgroundOfBlock lattice_of(const BlockField& sizes, const BlockLayout& layout, const LatticeOptions& options,
                             Exchange& exchange, const Run& run)
{
    const SizeRange range = range_of_all(sizes.range(), exchange);
    check_lattice(layout.grid, range, options, exchange.rank() == 0 ? run : quiet(run));
    const double size = field_lattice_size(layout.grid, range, options);
    return [&, size](int32_t block, const Run& of_block) {
        if (block < 0)
            return TetMesh();
        const TetMesh slab = lattice_slab(layout.grid, size, layout.start(block), layout.start(block + 1), of_block);
        return part_in_block(slab, layout, block);
    };
}

// The parts of a background that the first rank has, for the rank of each block. Each has its blocks in their order.
Array<TetMesh> dealt_out(TetMesh whole, const BlockLayout& layout, const BlockShares& shares, Exchange& exchange)
{
    Array<Array<unsigned char>> send(to_size(exchange.ranks()));
    if (exchange.rank() == 0)
        for (int32_t r = 0; r < exchange.ranks(); ++r) {
            const OwnBlocks of_rank = shares.of(r);
            Parcel parcel;
            for (int32_t b = of_rank.first; b < of_rank.end(); ++b)
                pack(part_in_block(whole, layout, b), parcel);
            send[r] = parcel.take_all();
        }
    whole = TetMesh();
    Parcel mine(exchange.all_to_all(send).items);
    Array<TetMesh> parts(shares.own(exchange).count);
    for (TetMesh& part : parts)
        unpack(mine, part);
    return parts;
}

void require_one_piece(const Grid& grid)
{
    if (!fits_in_one_piece(grid))
        throw Error(CLEFT_ERROR_TOO_LARGE,
                    "blocks are thinner than two tetrahedra, so that particles need the volume in one piece, and it "
                    "has more than 2147483647 voxels: set a larger block or a smaller size");
}

// Where blocks are too thin for particles of their own, the first rank makes those of the volume.
BackgroundOfBlock whole_particles(const BlockField& sizes, const BlockLayout& layout, const BlockShares& shares,
                                  const BackgroundOptions& options, Exchange& exchange, const Run& run)
{
    require_one_piece(layout.grid);
    if (exchange.rank() == 0 && exchange.ranks() > 1)
        run.warn("the first rank makes the particles alone, since blocks are thinner than two tetrahedra");
    const Planes wanted{0, exchange.rank() == 0 ? layout.grid.dims[2] : 0};
    TetMesh whole;
    {
        const SizingField all = swapped_planes(sizes, wanted, exchange);
        if (exchange.rank() == 0)
            whole = row_of(options.kind).make(all, options, run);
    }
    const auto parts = std::make_shared<Array<TetMesh>>(dealt_out(std::move(whole), layout, shares, exchange));
    const int32_t first = shares.own(exchange).first;
    return [=](int32_t block, const Run&) {
        return block < 0 ? TetMesh() : std::exchange((*parts)[block - first], TetMesh());
    };
}

BackgroundOfBlock particles_of(const BlockField& sizes, const BlockLayout& layout, const BlockShares& shares,
                               const BackgroundOptions& options, Exchange& exchange, const Run& run)
{
    if (!have_room_for_particles(layout, range_of_all(sizes.range(), exchange)))
        return whole_particles(sizes, layout, shares, options, exchange, run);
    return particles_of_blocks(sizes, layout, shares, options.particles, exchange, run);
}

}  // namespace

BackgroundOfBlock backgrounds_of_rank(const BlockField& sizes, const BlockLayout& layout, const BlockShares& shares,
                                      const BackgroundOptions& options, Exchange& exchange, const Run& run)
{
    Stage stage(run, "background", {{"background", 1}});
    const Run of_background = stage.next();
    switch (options.kind) {
        case BackgroundKind::octree:
            return octree_of(sizes, layout, exchange);
        case BackgroundKind::lattice:
            return lattice_of(sizes, layout, options.lattice, exchange, of_background);
        case BackgroundKind::particles:
            break;
    }
    return particles_of(sizes, layout, shares, options, exchange, of_background);
}

}  // namespace cleft
