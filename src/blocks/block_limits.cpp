// The planes of a block are looked at with a few beside them, in which windows of points end.
#include "blocks/block_limits.hpp"

#include "base/quiet_run.hpp"
#include "base/stage.hpp"
#include "blocks/block_shares.hpp"
#include "sizing/surface_sizes.hpp"
#include "volume/label_planes.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Curvatures are fitted in windows of six voxels, of points that need three on either side.
constexpr int32_t kPlanesOfWindow = 16;

void add_limits(const VolumeParts& volume, Planes block, double error, Array<SizeLimit>& limits, const Run& run)
{
    const Planes planes = planes_around(volume.grid, block, kPlanesOfWindow);
    const int64_t first = planes.first * volume.grid.plane_size();
    const Volume part = volume.planes(planes)->cropped(planes);
    for (SizeLimit limit : sizes_for_error(part, error, run)) {
        limit.voxel += first;
        if (block.first * volume.grid.plane_size() <= limit.voxel &&
            limit.voxel < block.end() * volume.grid.plane_size())
            limits.push_back(limit);
    }
}

// Those in some planes of a list that ascends.
std::pair<const SizeLimit*, const SizeLimit*> between(const Array<SizeLimit>& limits, Planes planes, int64_t plane_size)
{
    const auto at = [&](int64_t plane) {
        return std::lower_bound(limits.data(), limits.data() + limits.size(), plane * plane_size,
                                [](const SizeLimit& limit, int64_t voxel) { return limit.voxel < voxel; });
    };
    return {at(planes.first), at(planes.end())};
}

}  // namespace

BlockLimits::BlockLimits(const VolumeParts& volume, const BlockLayout& layout, double error, Planes wanted,
                         Exchange& exchange, const Run& run)
    : plane_size_(layout.grid.plane_size())
{
    if (error <= 0)
        return;
    const OwnBlocks own = BlockShares::equal(layout.count, exchange.ranks()).own(exchange);
    Steps steps(run, Array<Step>(std::max(own.count, 1), {nullptr, 1}));
    Array<SizeLimit> found;
    for (int32_t b = own.first; b < own.end(); ++b)
        add_limits(volume, layout.planes(b), error, found, quiet(steps.next()));
    // The least of a voxel counts, so those of one voxel may come in any order.
    std::sort(found.begin(), found.end(), [](const SizeLimit& a, const SizeLimit& b) { return a.voxel < b.voxel; });
    const Array<Planes> wanted_by = exchange.all_gather(Array<Planes>{wanted});
    Array<Array<SizeLimit>> send(to_size(exchange.ranks()));
    for (int32_t r = 0; r < exchange.ranks(); ++r) {
        const auto [first, last] = between(found, wanted_by[r], plane_size_);
        send[r] = Array<SizeLimit>(first, last);
    }
    // Ranks have planes in their order.
    limits_ = exchange.all_to_all(send).items;
}

Array<SizeLimit> BlockLimits::in(Planes planes) const
{
    const auto [first, last] = between(limits_, planes, plane_size_);
    Array<SizeLimit> out(first, last);
    for (SizeLimit& limit : out)
        limit.voxel -= planes.first * plane_size_;
    return out;
}

}  // namespace cleft
