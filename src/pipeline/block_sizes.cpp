// A block's planes are computed with those around it as a volume of their own, of which the block keeps its own.
#include "pipeline/block_sizes.hpp"

#include "background/octree_tree.hpp"
#include "base/stage.hpp"
#include "pipeline/block_seams.hpp"
#include "pipeline/quiet_run.hpp"
#include "sizing/compute.hpp"
#include "sizing/number_limit.hpp"
#include "sizing/volume_sizing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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
    const double of_block = std::max(kSizeOfBlock * layout.thickness(), layout.grid.spacing.maxCoeff());
    out.size_max = std::max(std::min(of_volume, of_block), options.size_min);
    return out;
}

// The planes that sizes of a block depend on. A feature is seen within twice its size, and a small size raises others
// until they have grown to the greatest one.
Planes planes_with_a_say(const Grid& grid, Planes block, const SizingOptions& options)
{
    // Curvatures are fitted in windows of five voxels, of points that need three on either side.
    constexpr double kWindows = 16;
    const double greatest = std::max(options.size, options.size_max);
    const double reach = greatest * std::max(1 / options.gradation, 2 / options.feature_scale);
    const double planes = std::min(std::ceil(reach / grid.spacing[2]) + kWindows, static_cast<double>(grid.dims[2]));
    const int32_t first = std::max(0, block.first - static_cast<int32_t>(planes));
    return {first, std::min(grid.dims[2], block.end() + static_cast<int32_t>(planes)) - first};
}

SizingField sizes_of_block(const VolumeParts& volume, Planes block, SizingOptions options, const Run& run)
{
    const Planes planes = planes_with_a_say(volume.grid, block, options);
    const int64_t plane = volume.grid.plane_size();
    if (options.user)
        options.user += planes.first * plane;
    const Volume part = volume.planes(planes)->cropped(planes);
    SizingField around = compute_sizing(part, options, quiet(run));
    SizingField own{part.grid(), {}, around.gradation};
    own.grid.dims[2] = block.count;
    const auto first = around.h.begin() + (block.first - planes.first) * plane;
    own.h.assign(first, first + own.grid.size());
    return own;
}

// What the kind of the background has, for sizes that particles would need so many tetrahedra for.
double of_kind(BackgroundKind kind, double particle_tets)
{
    return kind == BackgroundKind::octree ? kTetsOverParticles * particle_tets : particle_tets;
}

}  // namespace

SizingField sizes_of_own_blocks(const VolumeParts& volume, const BlockLayout& layout, const PipelineOptions& options,
                                Exchange& exchange, const Run& run)
{
    Stage stage(run, "sizing", {{"sizing: blocks", 1}});
    const Run of_blocks = stage.next();
    const OwnBlocks own = own_blocks(layout.count, exchange);
    SizingOptions sizing = bounded(options.sizing, layout);
    SizingField field{layout.grid, {}, sizing.gradation};
    field.first = layout.planes(own.first).first * layout.grid.plane_size();
    const auto expected_at = [&](double raised) {
        sizing.raised = raised;
        field.h.clear();
        Array<double> tets;
        Steps steps(of_blocks, Array<Step>(std::max(own.count, 1), {nullptr, 1}));
        for (int32_t b = own.first; b < own.end(); ++b) {
            const SizingField of_block = sizes_of_block(volume, layout.planes(b), sizing, steps.next());
            tets.push_back(expected_particle_tets(of_block));
            field.h.insert(field.h.end(), of_block.h.begin(), of_block.h.end());
        }
        // In the order of the blocks, so that the sum is the same for any number of ranks.
        const Array<double> all = exchange.all_gather(tets);
        return of_kind(options.background.kind, std::accumulate(all.begin(), all.end(), 0.0));
    };
    double expected = 0;
    const auto number = [&](double raised) { return expected = expected_at(raised); };
    const bool is_limited = limits_number(options.sizing) && row_of(options.background.kind).tets_near_limit;
    const NumberLimit limit{is_limited ? options.sizing.max_tets : INFINITY,
                            std::min(layout.grid.spacing.minCoeff(), sizing.size_max), layout.grid.extent().minCoeff()};
    keep_to_number(
        limit, number, [&] { return expected; }, exchange.rank() == 0 ? run : quiet(run));
    const SizeRange range = range_of_all(field, exchange);
    run.note("sizing.least", range.least);
    run.note("sizing.greatest", range.greatest);
    return field;
}

SizingField swapped_planes(const SizingField& own, Planes wanted, Exchange& exchange)
{
    const int64_t plane = own.grid.plane_size();
    const Array<int32_t> first = exchange.all_gather(Array<int32_t>{wanted.first}),
                         end = exchange.all_gather(Array<int32_t>{wanted.end()});
    Array<Array<float>> send(to_size(exchange.ranks()));
    for (int32_t r = 0; r < exchange.ranks(); ++r) {
        const int64_t low = std::max(first[r] * plane, own.first),
                      high = std::min(end[r] * plane, own.first + own.h.count());
        if (low < high)
            send[r].assign(own.h.begin() + (low - own.first), own.h.begin() + (high - own.first));
    }
    SizingField out{own.grid, std::move(exchange.all_to_all(send).items), own.gradation};
    out.first = wanted.first * plane;
    CLEFT_ASSERT(out.h.count() == wanted.count * plane);
    return out;
}

SizeRange range_of_all(const SizingField& own, Exchange& exchange)
{
    // A rank without blocks has no sizes.
    const bool has_sizes = !own.h.empty();
    const Array<double> least = exchange.all_gather(Array<double>{has_sizes ? own.least() : INFINITY}),
                        greatest = exchange.all_gather(Array<double>{has_sizes ? own.greatest() : -INFINITY});
    return {*std::min_element(least.begin(), least.end()), *std::max_element(greatest.begin(), greatest.end())};
}

}  // namespace cleft
