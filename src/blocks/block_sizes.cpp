// A block's planes are computed with those around it as a volume of their own, of which the block keeps its own.
#include "blocks/block_sizes.hpp"

#include "background/octree_tree.hpp"
#include "base/quiet_run.hpp"
#include "base/stage.hpp"
#include "blocks/block_limits.hpp"
#include "blocks/block_shares.hpp"
#include "sizing/compute.hpp"
#include "sizing/number_limit.hpp"
#include "sizing/volume_sizing.hpp"
#include "volume/label_planes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace cleft
{

namespace
{

// Of the thickness of a block, the greatest size.
constexpr double kSizeOfBlock = 0.25;

// With the limits of the whole volume, since that of a part would be smaller.
SizingOptions bounded(const SizingOptions& options, const BlockLayout& layout)
{
    SizingOptions out = options;
    out.max_tets = 0;
    out.expected_tets = nullptr;
    const double of_volume = options.size_max > 0 ? options.size_max : default_size_max(layout.grid);
    const double of_block =
        std::max({kSizeOfBlock * layout.thickness(), layout.grid.spacing.maxCoeff(), options.size_min});
    out.size_max = std::max(std::min(of_volume, of_block), options.size_min);
    out.size = std::min(options.size, of_block);  // 0: it is not given
    return out;
}

// The planes that sizes of a block depend on. A feature is seen within twice its size, and a small size raises others
// until they have grown to the greatest one.
Planes planes_with_a_say(const Grid& grid, Planes block, const SizingOptions& options)
{
    // Points of interfaces, and which parts are one voxel thick, follow from voxels nearby.
    constexpr double kBeside = 6;
    const double greatest = std::max(options.size, options.size_max);
    const double reach = greatest * std::max(1 / options.gradation, 2 / options.feature_scale);
    const double planes = std::min(std::ceil(reach / grid.spacing[2]) + kBeside, static_cast<double>(grid.dims[2]));
    return planes_around(grid, block, static_cast<int32_t>(planes));
}

// Those that sizes of all blocks of a rank depend on.
Planes planes_wanted(const BlockLayout& layout, const OwnBlocks& own, const SizingOptions& options)
{
    if (own.count == 0)
        return {};
    const int32_t first = layout.planes(own.first).first;
    return planes_with_a_say(layout.grid, {first, layout.planes(own.end() - 1).end() - first}, options);
}

SizingField sizes_of_block(const VolumeParts& volume, Planes block, const BlockLimits& limits, SizingOptions options,
                           const Run& run)
{
    const Planes planes = planes_with_a_say(volume.grid, block, options);
    const int64_t plane = volume.grid.plane_size();
    if (options.user)
        options.user += planes.first * plane;
    const Volume part = volume.planes(planes)->cropped(planes);
    SizingField around = compute_sizing(part, options, limits.in(planes), quiet(run));
    SizingField own{part.grid(), {}, around.gradation};
    own.grid.dims[2] = block.count;
    const auto first = around.h.begin() + (block.first - planes.first) * plane;
    own.h.assign(first, first + own.grid.size());
    return own;
}

}  // namespace

BlockField sizes_of_own_blocks(const VolumeParts& volume, const BlockLayout& layout, const PipelineOptions& options,
                               Exchange& exchange, const Run& run)
{
    const OwnBlocks own = BlockShares::equal(layout.count, exchange.ranks()).own(exchange);
    SizingOptions sizing = bounded(options.sizing, layout);
    const double error = error_of_sizes(sizing);
    Stage stage(run, "sizing", {{"sizing: curvature", error > 0 ? 1.0 : 0}, {"sizing: blocks", 1}});
    const BlockLimits limits(volume, layout, error, planes_wanted(layout, own, sizing), exchange, stage.next());
    const Run of_blocks = stage.next();
    BlockField field(layout.grid, sizing.gradation, exchange.scratch());
    double of_particles = 0;
    const auto expected_at = [&](double raised) {
        sizing.raised = raised;
        field.clear();
        Array<double> tets;
        Steps steps(of_blocks, Array<Step>(std::max(own.count, 1), {nullptr, 1}));
        for (int32_t b = own.first; b < own.end(); ++b) {
            const SizingField of_block = sizes_of_block(volume, layout.planes(b), limits, sizing, steps.next());
            tets.push_back(expected_particle_tets(of_block));
            field.add(layout.planes(b), of_block.h);
        }
        // In the order of the blocks, so that the sum is the same for any number of ranks.
        Array<double> all = exchange.all_gather(tets);
        of_particles = std::accumulate(all.begin(), all.end(), 0.0);
        field.expect(std::move(all));
        if (options.background.kind != BackgroundKind::octree)
            return of_particles;
        return rough_octree_tets(layout.grid.extent(), range_of_all(field.range(), exchange), of_particles);
    };
    const bool is_limited = limits_number(options.sizing) && row_of(options.background.kind).tets_near_limit;
    const NumberLimit limit{is_limited ? options.sizing.max_tets : INFINITY,
                            std::min(layout.grid.spacing.minCoeff(), sizing.size_max), layout.grid.extent().minCoeff()};
    keep_to_number(
        limit, expected_at, [&] { return of_particles; }, exchange.rank() == 0 ? run : quiet(run));
    const SizeRange range = range_of_all(field.range(), exchange);
    run.note("sizing.least", range.least);
    run.note("sizing.greatest", range.greatest);
    return field;
}

SizingField swapped_planes(const BlockField& own, Planes wanted, Exchange& exchange)
{
    const Array<Planes> wanted_by = exchange.all_gather(Array<Planes>{wanted});
    const Planes here = own.planes();
    Array<Array<float>> send(to_size(exchange.ranks()));
    for (int32_t r = 0; r < exchange.ranks(); ++r) {
        const int32_t low = std::max(wanted_by[r].first, here.first), high = std::min(wanted_by[r].end(), here.end());
        if (low < high)
            send[r] = own.values({low, high - low});
    }
    SizingField out{own.grid(), std::move(exchange.all_to_all(send).items), own.gradation()};
    out.first = wanted.first * own.grid().plane_size();
    CLEFT_ASSERT(out.h.count() == wanted.count * own.grid().plane_size());
    return out;
}

SizeRange range_of_all(const SizeRange& own, Exchange& exchange)
{
    SizeRange all = own;
    for (const SizeRange& of_rank : exchange.all_gather(Array<SizeRange>{own}))
        all = {std::min(all.least, of_rank.least), std::max(all.greatest, of_rank.greatest)};
    return all;
}

BlockField::BlockField(const Grid& whole, double gradation, const std::string& scratch)
    : grid_(whole), gradation_(gradation), range_{INFINITY, -INFINITY}, sizes_(scratch)
{
}

void BlockField::clear()
{
    slabs_.clear();
    sizes_.clear();
    range_ = {INFINITY, -INFINITY};
}

void BlockField::add(Planes planes, const Array<float>& h)
{
    const auto [least, greatest] = std::minmax_element(h.begin(), h.end());
    range_ = {std::min<double>(range_.least, *least), std::max<double>(range_.greatest, *greatest)};
    sizes_.put(slabs_.count(), h);
    slabs_.push_back(planes);
}

Array<float> BlockField::values(Planes planes) const
{
    const int64_t plane = grid_.plane_size();
    Array<float> out;
    out.reserve(to_size(planes.count * plane));
    for (int64_t s = 0; s < slabs_.count(); ++s) {
        const Planes& slab = slabs_[s];
        const int32_t low = std::max(planes.first, slab.first), high = std::min(planes.end(), slab.end());
        if (low < high)
            sizes_.append(s, (low - slab.first) * plane, (high - low) * plane, out);
    }
    return out;
}

Planes BlockField::planes() const
{
    if (slabs_.empty())
        return {};
    const int32_t first = slabs_.front().first;
    return {first, slabs_.back().end() - first};
}

}  // namespace cleft
