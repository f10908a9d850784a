// Reads planes as the work asks for them, and does the last steps with sums over all ranks.
#include "blocks/rank_mesh.hpp"

#include "base/quiet_run.hpp"
#include "base/stage.hpp"
#include "blocks/block_shares.hpp"
#include "blocks/block_sizes.hpp"
#include "blocks/held_planes.hpp"
#include "blocks/mesh_blocks.hpp"
#include "blocks/rank_backgrounds.hpp"
#include "finishing/finish.hpp"
#include "mesh/materials.hpp"
#include "mesh/strip.hpp"
#include "parts/rank_sums.hpp"
#include "volume/frame.hpp"
#include "volume/label_planes.hpp"
#include "volume/label_values.hpp"

#include <algorithm>
#include <unordered_map>

namespace cleft
{

namespace
{

Window window_of(const Grid& grid, Planes planes)
{
    return {{0, 0, planes.first}, {grid.dims[0], grid.dims[1], planes.count}};
}

// Labels in the order in which they come first, and the sums of their voxels.
class LabelSums
{
public:
    void add(UserLabel label, int64_t voxels)
    {
        const auto [place, is_new] = place_.emplace(number_of(label), sums_.labels.size());
        if (is_new) {
            sums_.labels.push_back(label);
            sums_.voxels.push_back(0);
            if (sums_.labels.size() > kGreatestLabelCount)
                refuse_label_count();
        }
        sums_.voxels[place->second] += voxels;
    }
    LabelCounts take() { return std::move(sums_); }

private:
    std::unordered_map<int32_t, size_t> place_;
    LabelCounts sums_;
};

// The volume around what is worked on. Weights cost more than anything else here, so planes keep them.
VolumeParts read_as_asked(const SharedVoxels& voxels, const LabelCounts& labels, int smooth, const std::string& scratch,
                          const Run& run)
{
    struct Last {
        Planes sampled;
        std::shared_ptr<const Volume> volume;
    };
    const auto last = std::make_shared<Last>();
    const auto held = std::make_shared<HeldPlanes>(scratch);
    const Grid& whole = voxels.grid;
    const auto make = [=, &voxels, &labels, &whole](Planes planes) {
        const Planes read = planes_around(whole, planes, kPlanesOfWeight + kPlanesOfSample);
        const Array<unsigned char> bytes = read_window(voxels.source, window_of(whole, read));
        return Volume::from_planes(voxels.source.type, bytes.data(), whole, read, labels, smooth, uncounted(run));
    };
    return {whole, [=, &labels, &whole](Planes wanted) {
                if (last->volume && last->sampled.first <= wanted.first && wanted.end() <= last->sampled.end())
                    return last->volume;
                last->volume = nullptr;  // its memory is free before more is taken
                held->fill(planes_around(whole, wanted, kPlanesOfSample), make);
                last->volume = std::make_shared<const Volume>(Volume::from_stored_planes(
                    whole, wanted, labels, smooth, [&](int32_t k) { return held->plane(k); }));
                last->sampled = wanted;
                return last->volume;
            }};
}

void strip_piece(LabelledMesh& piece, const KeptMaterials& kept)
{
    strip(piece.points, piece.tets, piece.material, [&](Material m) { return kept.has(m); });
}

// What is told of the pieces of all ranks. What is not kept is taken out of them.
void finish(const MeshPieces& pieces, const SharedVoxels& voxels, const LabelCounts& labels,
            const PipelineOptions& options, Exchange& exchange, const Run& run)
{
    const bool tells = tells_of_missed_goal(options, exchange.ranks(), run);
    int64_t kept = 0;
    Array<double> volumes(labels.labels.size(), 0.0);
    MissedGoal missed;
    for (int32_t i = 0; i < pieces.count; ++i) {
        const LabelledMesh& piece = pieces.read(i);
        kept += kept_tets(piece, options.kept);
        const Array<double> more = material_volumes(piece, static_cast<Material>(volumes.size()), run);
        std::transform(more.begin(), more.end(), volumes.begin(), volumes.begin(), std::plus<>());
        if (tells)
            missed.join(missed_goal(piece, options, run));
        if (!options.kept.all())
            strip_piece(pieces.at(i), options.kept);
    }
    require_kept(sum_of_ranks(kept, exchange));
    volumes = sums_of_ranks(volumes, exchange);
    const Array<MissedGoal> of_ranks = exchange.all_gather(Array<MissedGoal>{missed});
    if (exchange.rank() > 0)
        return;
    warn_of_volume_differences(voxels.grid, labels, volumes, options.kept, run);
    for (int32_t r = 1; r < exchange.ranks(); ++r)
        missed.join(of_ranks[r]);
    if (tells)
        warn_of_missed_goal(missed, voxels.grid, options, run);
}

}  // namespace

std::string needs_whole_mesh(const PipelineOptions& options, const Grid& grid)
{
    // First what no block would change.
    if (options.tets > 0)
        return "tets asks for a number";
    if (options.strict)
        return "strict is on";
    if (options.sizing.anisotropy > 1)
        return "anisotropy is above 1";
    return BlockLayout::of(grid, options.block).count == 1 ? "block is 0 or more than half of the planes" : "";
}

LabelCounts labels_of_all(const SharedVoxels& voxels, int32_t block, Exchange& exchange, const Run& run)
{
    const BlockLayout layout = BlockLayout::of(voxels.grid, block);
    const OwnBlocks own = BlockShares::equal(layout.count, exchange.ranks()).own(exchange);
    LabelSums of_rank;
    for (int32_t b = own.first; b < own.end(); ++b) {
        const Window window = window_of(voxels.grid, layout.planes(b));
        const Array<unsigned char> bytes = read_window(voxels.source, window);
        const LabelCounts found = Volume::count_labels(voxels.source.type, bytes.data(), window.size(), uncounted(run));
        for (size_t i = 0; i < found.labels.size(); ++i)
            of_rank.add(found.labels[i], found.voxels[i]);
    }
    const LabelCounts mine = of_rank.take();
    const Array<UserLabel> labels = exchange.all_gather(mine.labels);
    const Array<int64_t> counts = exchange.all_gather(mine.voxels);
    LabelSums of_all;
    for (size_t i = 0; i < labels.size(); ++i)
        of_all.add(labels[i], counts[i]);
    return of_all.take();
}

MeshPieces mesh_of_rank(const SharedVoxels& voxels, const LabelCounts& labels, int smooth,
                        const PipelineOptions& options, Exchange& exchange, const Run& run)
{
    const double share = options.background.kind == BackgroundKind::particles ? 10 : 0;
    Steps steps(run, {{nullptr, 15}, {nullptr, share}, {nullptr, 83 - share}, {nullptr, 2}});
    const BlockLayout layout = BlockLayout::of(voxels.grid, options.block);
    const VolumeParts volume = read_as_asked(voxels, labels, smooth, exchange.scratch(), run);
    const BlockField sizes = sizes_of_own_blocks(volume, layout, options, exchange, steps.next());
    // From here on, ranks have about as many tetrahedra, not as many planes.
    const BlockShares shares = BlockShares::balanced(sizes.expected_tets(), exchange.ranks());
    const BackgroundOfBlock background =
        backgrounds_of_rank(sizes, layout, shares, options.background, exchange, steps.next());
    MeshPieces pieces = mesh_own_blocks(volume, layout, shares, background, options, exchange, steps.next());
    finish(pieces, voxels, labels, options, exchange, steps.next());
    return pieces;
}

}  // namespace cleft
