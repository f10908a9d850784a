// The order of the blocks and of the seams.
#include "blocks/mesh_blocks.hpp"

#include "base/stage.hpp"
#include "blocks/block_parcels.hpp"
#include "blocks/block_seams.hpp"
#include "blocks/block_store.hpp"
#include "mesh/piece.hpp"

namespace cleft
{

namespace
{

// The blocks of a rank, and what is done with them.
class BlockRun
{
public:
    BlockRun(const VolumeParts& volume, const BlockLayout& layout, const BlockShares& shares,
             const PipelineOptions& options, Exchange& exchange)
        : volume_(volume),
          layout_(layout),
          shares_(shares),
          options_(options),
          exchange_(exchange),
          own_(shares.own(exchange)),
          blocks_(std::make_shared<BlockStore>(own_.first, own_.count, exchange.scratch()))
    {
    }

    void cut_out(const BackgroundOfBlock& background, const Run& run)
    {
        // Ranks make backgrounds together, those with fewer blocks too.
        const int32_t most = shares_.greatest_count();
        Steps steps(run, Array<Step>(most, {nullptr, 1}));
        for (int32_t i = 0; i < most; ++i) {
            const bool is_own = i < own_.count;
            const TetMesh mine = background(is_own ? own_.first + i : -1, steps.next());
            if (is_own)
                block(own_.first + i) = block_of(mine, layout_.box(), run);
        }
    }

    void snap(const Run& run)
    {
        Steps steps = steps_of_blocks(run);
        for (int32_t b = own_.first; b < own_.end(); ++b)
            snap_block(volume_, block(b), options_, steps.next());
    }

    void snap_seams(const Run& run)
    {
        // What a block gave to a seam, until it gets it back.
        Array<NearSnapped> given(own_.count);
        const auto cut_out = [&](int32_t b, const Array<Vec3>& places) {
            NearSnapped near = near_snapped(block(b), places);
            NearSnapped& kept = given[b - own_.first];
            kept.vertices = Array<int32_t>(near.vertices.begin(), near.vertices.end());
            kept.tets = Array<int32_t>(near.tets.begin(), near.tets.end());
            return near;
        };
        Steps steps = steps_of_blocks(run);
        work_at_seams<NearSnapped, Snapped>(
            shares_,
            {[&](int32_t b) { return places_of_cut(block(b)); }, cut_out,
             [&](int32_t, const NearSnapped& lower, const NearSnapped& upper) {
                 return snap_seam(volume_, lower.side, upper.side, options_, steps.next());
             },
             [&](int32_t b, const Snapped& snapped) { take_back(block(b), given[b - own_.first], snapped); }, pack,
             unpack, pack, unpack},
            exchange_);
    }

    void mesh(const Run& run)
    {
        Steps steps = steps_of_blocks(run);
        for (int32_t b = own_.first; b < own_.end(); ++b) {
            mesh_block(volume_, block(b), options_, steps.next());
            // Nothing that comes later needs the rest.
            LabelledMesh mesh = std::exchange(block(b).mesh, LabelledMesh());
            block(b) = Block();
            block(b).mesh = std::move(mesh);
        }
    }

    void improve_seams(const Run& run)
    {
        const BoundingBox box = layout_.box();
        Steps steps = steps_of_blocks(run);
        work_at_seams<LabelledMesh, LabelledMesh>(
            shares_,
            {[&](int32_t b) { return places_of_cut(block(b).mesh, box, run); },
             [&](int32_t b, const Array<Vec3>& places) { return taken_near(block(b).mesh, places, box, run); },
             [&](int32_t b, LabelledMesh lower, const LabelledMesh& upper) {
                 return improve_seam(volume_, std::move(lower), upper, layout_.start(b + 1), options_, steps.next());
             },
             [&](int32_t b, const LabelledMesh& part) { block(b).mesh = joined(std::move(block(b).mesh), part, run); },
             pack, unpack, pack, unpack},
            exchange_);
    }

    MeshPieces pieces() const
    {
        const auto read = [blocks = blocks_, first = own_.first](int32_t piece) -> const LabelledMesh& {
            return blocks->read(first + piece).mesh;
        };
        const auto at = [blocks = blocks_, first = own_.first](int32_t piece) -> LabelledMesh& {
            return blocks->at(first + piece).mesh;
        };
        return {own_.count, read, at};
    }

private:
    Block& block(int32_t b) { return blocks_->at(b); }
    // A rank works at no more seams than it has blocks.
    Steps steps_of_blocks(const Run& run) const
    {
        return Steps(run, Array<Step>(std::max(own_.count, 1), {nullptr, 1}));
    }

    const VolumeParts& volume_;
    const BlockLayout& layout_;
    const BlockShares& shares_;
    const PipelineOptions& options_;
    Exchange& exchange_;
    OwnBlocks own_;
    std::shared_ptr<BlockStore> blocks_;  // shared with the pieces
};

}  // namespace

MeshPieces mesh_own_blocks(const VolumeParts& volume, const BlockLayout& layout, const BlockShares& shares,
                           const BackgroundOfBlock& background, const PipelineOptions& options, Exchange& exchange,
                           const Run& run)
{
    Stage stage(run, "blocks", {{nullptr, 5}, {nullptr, 20}, {nullptr, 4}, {nullptr, 60}, {nullptr, 15}});
    BlockRun blocks(volume, layout, shares, options, exchange);
    blocks.cut_out(background, stage.next());
    blocks.snap(stage.next());
    blocks.snap_seams(stage.next());
    blocks.mesh(stage.next());
    blocks.improve_seams(stage.next());
    run.note("blocks.count", layout.count);
    return blocks.pieces();
}

LabelledMesh mesh_in_blocks(const Volume& volume, const TetMesh& background, const PipelineOptions& options,
                            const Run& run)
{
    Exchange alone = Exchange::alone();
    const BlockLayout layout = BlockLayout::of(volume.grid(), options.block);
    const auto of_block = [&](int32_t block, const Run&) { return part_in_block(background, layout, block); };
    const BlockShares shares = BlockShares::equal(layout.count, 1);
    const MeshPieces blocks = mesh_own_blocks(parts_of(volume), layout, shares, of_block, options, alone, run);
    LabelledMesh whole;
    for (int32_t i = 0; i < blocks.count; ++i)
        whole = joined(std::move(whole), std::exchange(blocks.at(i), LabelledMesh()), run);
    return whole;
}

TetMesh part_in_block(const TetMesh& background, const BlockLayout& layout, int32_t block)
{
    return piece_of(background, [&](int64_t t) {
        return layout.block_at(middle_of(background.points, background.tets[t])) == block;
    });
}

VolumeParts parts_of(const Volume& whole)
{
    // Shared with nobody: it is the caller's.
    const std::shared_ptr<const Volume> lent(&whole, [](const Volume*) {});
    return {whole.grid(), [lent](Planes) { return lent; }};
}

}  // namespace cleft
