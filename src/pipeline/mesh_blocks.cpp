// The order of the blocks and of the seams.
#include "pipeline/mesh_blocks.hpp"

#include "base/stage.hpp"
#include "mesh/piece.hpp"
#include "pipeline/block_seams.hpp"

namespace cleft
{

namespace
{

void pack(const Snapped& snapped, Parcel& parcel)
{
    parcel.put(snapped.vertices);
    parcel.put(snapped.kept);
}

void unpack(Parcel& parcel, Snapped& snapped)
{
    parcel.take(snapped.vertices);
    parcel.take(snapped.kept);
}

void pack(const NearSnapped& near, Parcel& parcel)
{
    parcel.put(near.side.background.points);
    parcel.put(near.side.background.tets);
    pack(near.side.snapped, parcel);
}

void unpack(Parcel& parcel, NearSnapped& near)
{
    parcel.take(near.side.background.points);
    parcel.take(near.side.background.tets);
    unpack(parcel, near.side.snapped);
}

void pack(const LabelledMesh& mesh, Parcel& parcel)
{
    parcel.put(mesh.points);
    parcel.put(mesh.tets);
    parcel.put(mesh.material);
}

void unpack(Parcel& parcel, LabelledMesh& mesh)
{
    parcel.take(mesh.points);
    parcel.take(mesh.tets);
    parcel.take(mesh.material);
}

// The blocks of a rank, and what is done with them.
class BlockRun
{
public:
    BlockRun(const VolumeParts& volume, const BlockLayout& layout, const PipelineOptions& options, Exchange& exchange)
        : volume_(volume),
          layout_(layout),
          options_(options),
          exchange_(exchange),
          own_(own_blocks(layout.count, exchange))
    {
    }

    void cut_out(const TetMesh& background, const Run& run)
    {
        Array<int32_t> block(background.tets.size());
        for (int64_t t = 0; t < background.tets.count(); ++t)
            block[t] = layout_.block_at(middle_of(background.points, background.tets[t]));
        for (int32_t b = own_.first; b < own_.end(); ++b)
            blocks_.push_back(
                block_of(piece_of(background, [&](int64_t t) { return block[t] == b; }), layout_.box(), run));
    }

    void snap(const Run& run)
    {
        Steps steps = steps_of_blocks(run);
        for (Block& block : blocks_)
            snap_block(volume_, block, options_, steps.next());
    }

    void snap_seams(const Run& run)
    {
        // What a block gave to a seam, until it gets it back.
        Array<NearSnapped> given(blocks_.size());
        const auto cut_out = [&](int32_t b, const Array<Vec3>& places) {
            NearSnapped near = near_snapped(block(b), places);
            NearSnapped& kept = given[b - own_.first];
            kept.vertices = Array<int32_t>(near.vertices.begin(), near.vertices.end());
            kept.tets = Array<int32_t>(near.tets.begin(), near.tets.end());
            return near;
        };
        Steps steps = steps_of_blocks(run);
        work_at_seams<NearSnapped, Snapped>(
            own_, layout_.count,
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
        for (Block& block : blocks_)
            mesh_block(volume_, block, options_, steps.next());
    }

    void improve_seams(const Run& run)
    {
        const BoundingBox box = layout_.box();
        Steps steps = steps_of_blocks(run);
        work_at_seams<LabelledMesh, LabelledMesh>(
            own_, layout_.count,
            {[&](int32_t b) { return places_of_cut(block(b).mesh, box, run); },
             [&](int32_t b, const Array<Vec3>& places) { return taken_near(block(b).mesh, places, box, run); },
             [&](int32_t b, LabelledMesh lower, const LabelledMesh& upper) {
                 return improve_seam(volume_, std::move(lower), upper, layout_.start(b + 1), options_, steps.next());
             },
             [&](int32_t b, const LabelledMesh& part) { block(b).mesh = joined(std::move(block(b).mesh), part, run); },
             pack, unpack, pack, unpack},
            exchange_);
    }

    LabelledMesh joined_blocks(const Run& run)
    {
        LabelledMesh whole;
        for (Block& block : blocks_) {
            whole = joined(std::move(whole), block.mesh, run);
            block.mesh = LabelledMesh();
        }
        return whole;
    }

private:
    Block& block(int32_t b) { return blocks_[b - own_.first]; }
    // A rank works at no more seams than it has blocks.
    Steps steps_of_blocks(const Run& run) const
    {
        return Steps(run, Array<Step>(std::max(own_.count, 1), {nullptr, 1}));
    }

    const VolumeParts& volume_;
    const BlockLayout& layout_;
    const PipelineOptions& options_;
    Exchange& exchange_;
    OwnBlocks own_;
    Array<Block> blocks_;
};

}  // namespace

LabelledMesh mesh_own_blocks(const VolumeParts& volume, const BlockLayout& layout, const TetMesh& background,
                             const PipelineOptions& options, Exchange& exchange, const Run& run)
{
    Stage stage(run, "blocks", {{nullptr, 1}, {nullptr, 20}, {nullptr, 4}, {nullptr, 60}, {nullptr, 15}});
    BlockRun blocks(volume, layout, options, exchange);
    blocks.cut_out(background, stage.next());
    blocks.snap(stage.next());
    blocks.snap_seams(stage.next());
    blocks.mesh(stage.next());
    blocks.improve_seams(stage.next());
    run.note("blocks.count", layout.count);
    return blocks.joined_blocks(run);
}

LabelledMesh mesh_in_blocks(const Volume& volume, const TetMesh& background, const PipelineOptions& options,
                            const Run& run)
{
    Exchange alone = Exchange::alone();
    return mesh_own_blocks(parts_of(volume), BlockLayout::of(volume.grid(), options.block), background, options, alone,
                           run);
}

VolumeParts parts_of(const Volume& whole)
{
    // Shared with nobody: it is the caller's.
    const std::shared_ptr<const Volume> lent(&whole, [](const Volume*) {});
    return {whole.grid(), [lent](Planes) { return lent; }};
}

}  // namespace cleft
