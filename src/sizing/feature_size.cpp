// The first two distance transforms of section 3 of the paper: from the interfaces to the medial axis, and back.
#include "sizing/feature_size.hpp"

#include "base/stage.hpp"
#include "base/touched_array.hpp"
#include "sizing/feature_transform.hpp"
#include "sizing/medial_axis.hpp"
#include "sizing/thin_parts.hpp"

#include <cmath>
#include <numeric>

namespace cleft
{
namespace
{

// Where few voxels are at interfaces, the medial places that matter are near them mostly: first comes the part of the
// volume up to so many of the greatest spacings from the interfaces. 16 are too few for a brain of half a millimetre a
// voxel, whose greatest feature size is 17 of them; more would leave less to save.
constexpr double kNear = 24;

// nearest[v] = v where is_site(v), else -1; returns the number of sites.
template <class IsSite>
int64_t mark_sites(Array<int32_t>& nearest, const Run& run, const IsSite& is_site)
{
    constexpr int64_t kVoxels = int64_t{1} << 16;
    Array<int64_t> counts(chunk_count(nearest.count(), kVoxels));
    parallel_chunks(run, nearest.count(), kVoxels, [&](int64_t chunk, int64_t begin, int64_t end) {
        int32_t count = 0;
        for (int64_t v = begin; v < end; ++v) {
            const bool site = is_site(v);
            nearest[v] = site ? static_cast<int32_t>(v) : -1;
            count += static_cast<int32_t>(site);
        }
        counts[chunk] = count;
    });
    return std::accumulate(counts.begin(), counts.end(), int64_t{0});
}

struct MedialAxis {
    const Grid& grid;
    VoxelCoordinates coordinates;
    const Array<uint8_t>& held;
    const NearestSites& nearest;  // medial voxel

    Vec3 centre(int32_t voxel) const
    {
        const auto at = coordinates.of(voxel);
        return grid.centre(at[0], at[1], at[2]);
    }

    // Whether the nearest medial voxel of a voxel at an interface, or next to one, is the nearest of all, those beyond
    // the reach of both transforms included. Such a voxel lies further from all interfaces than certain_beside().
    bool is_certain(int32_t voxel) const
    {
        if (!std::isfinite(nearest.reach))
            return true;
        const int32_t site = nearest.site[voxel];
        const double certain = nearest.certain_beside(grid) - 1.01 * grid.spacing.norm();
        return site >= 0 && (centre(voxel) - centre(site)).squaredNorm() < certain * certain;
    }

    // The voxel (i, j, k) and those that share a face with it; returns how many there are.
    size_t list_beside(int32_t i, int32_t j, int32_t k, FixedArray<int32_t, 7>& voxels) const
    {
        const FixedArray<int32_t, 3> at{i, j, k};
        const FixedArray<int64_t, 3> stride = grid.strides();
        const int64_t voxel = grid.index(i, j, k);
        voxels[0] = static_cast<int32_t>(voxel);
        size_t count = 1;
        for (int a = 0; a < 3; ++a) {
            if (at[a] > 0)
                voxels[count++] = static_cast<int32_t>(voxel - stride[a]);
            if (at[a] + 1 < grid.dims[a])
                voxels[count++] = static_cast<int32_t>(voxel + stride[a]);
        }
        return count;
    }

    // The distance from x, a point in the voxel (i, j, k), which the nearest medial voxel of the voxel or of one of its
    // neighbours holds.
    // The transform is exact for centres of voxels, but places of the axis lie up to a step beside them. So another
    // candidate may be nearer, and it is nearly always that of a neighbour.
    float distance(int32_t i, int32_t j, int32_t k, const Vec3& x, bool& certain) const
    {
        FixedArray<int32_t, 7> voxels;
        const size_t count = list_beside(i, j, k, voxels);
        double least = INFINITY;
        int32_t last = -1;
        for (size_t c = 0; c < count; ++c) {
            certain = certain && is_certain(voxels[c]);
            const int32_t site = nearest.site[voxels[c]];
            if (site < 0 || site == last)
                continue;
            last = site;
            const Vec3 place = centre(site) + medial_offset(held[site], grid.spacing);
            least = std::min(least, (place - x).squaredNorm());
        }
        return static_cast<float>(std::sqrt(least));
    }
};

struct FoundSizes {
    FeatureSizes sizes;
    bool are_certain = true;
};

// The interface voxels of some rows with their feature size.
FoundSizes sizes_of_rows(const MedialAxis& axis, const InterfacePoints& points, int64_t begin, int64_t end)
{
    const Grid& grid = axis.grid;
    FoundSizes found;
    for (int64_t row = begin; row < end; ++row) {
        const auto j = static_cast<int32_t>(row % grid.dims[1]);
        const auto k = static_cast<int32_t>(row / grid.dims[1]);
        for (int32_t i = 0; i < grid.dims[0]; ++i) {
            const int64_t voxel = row * grid.dims[0] + i;
            if (!points.contains(voxel))
                continue;
            const auto& offset = points[voxel].offset;
            const Vec3 x = grid.centre(i, j, k) + Vec3(offset[0], offset[1], offset[2]);
            found.sizes.voxel.push_back(static_cast<int32_t>(voxel));
            found.sizes.size.push_back(axis.distance(i, j, k, x, found.are_certain));
        }
    }
    return found;
}

FoundSizes read_at_interface(const MedialAxis& axis, const InterfacePoints& points, const Run& run)
{
    const int64_t rows = row_count(axis.grid);
    const int64_t grain = rows_per_chunk(axis.grid);
    Array<FoundSizes> parts(chunk_count(rows, grain));
    parallel_with_progress(run, rows, grain, [&](int64_t chunk, int64_t begin, int64_t end) {
        parts[chunk] = sizes_of_rows(axis, points, begin, end);
    });
    FoundSizes all;
    FeatureSizes& sizes = all.sizes;
    sizes.voxel.reserve(points.count());
    sizes.size.reserve(points.count());
    // In the order of the chunks, so that voxels ascend for any number of threads.
    for (FoundSizes& part : parts) {
        sizes.voxel.insert(sizes.voxel.end(), part.sizes.voxel.begin(), part.sizes.voxel.end());
        sizes.size.insert(sizes.size.end(), part.sizes.size.begin(), part.sizes.size.end());
        all.are_certain = all.are_certain && part.are_certain;
        part = {};
    }
    return all;
}

FeatureSizes without_medial_axis(const InterfacePoints& points, int64_t voxels)
{
    FeatureSizes all;
    for (int64_t v = 0; v < voxels; ++v)
        if (points.contains(v))
            all.voxel.push_back(static_cast<int32_t>(v));
    all.size.assign(all.voxel.size(), INFINITY);
    return all;
}

// Reaches of the transforms to try, one after the other. With the last one all sizes up to `most` are known.
Array<double> reaches_to_try(const Grid& grid, int64_t interface_voxels, double most)
{
    // A place of the axis lies up to a step beside its voxel, the voxel up to two from the last that is certain, and an
    // interface point up to a step and a half from the voxel that it is read at.
    const double last = most + 5 * grid.spacing.norm();
    const bool is_all = last >= grid.extent().norm();
    Array<double> reaches;
    const double near = kNear * grid.spacing.maxCoeff();
    // Both sides of the interfaces are less than a quarter of the volume: looking at it twice costs little then.
    const bool is_small = static_cast<double>(interface_voxels) * 2 * kNear < 0.25 * static_cast<double>(grid.size());
    if (is_small && near < last)
        reaches.push_back(near);
    reaches.push_back(is_all ? INFINITY : last);
    return reaches;
}

// Places that were found with a lesser reach are in `medial` already, and are found again.
FoundSizes sizes_within(double reach, const Labelling& labelling, const InterfacePoints& points, Array<uint8_t>& medial,
                        NearestSites& nearest, const Run& run)
{
    const Grid& grid = labelling.grid;
    Steps steps(run, {{"sizing: distances from interfaces", 14},
                      {"sizing: medial axis", 26},
                      {"sizing: distances from the medial axis", 13},
                      {"sizing: feature sizes", 4}});
    nearest.reach = reach;
    mark_sites(nearest.site, run, [&](int64_t v) { return points.contains(v); });
    feature_transform(grid, reach, nearest.site, steps.next());
    add_medial_places(labelling, points, nearest, medial, steps.next());
    // The same array serves both transforms, since the second needs only `medial` of the first.
    const int64_t medial_voxels = mark_sites(nearest.site, run, [&](int64_t v) { return medial[v] != 0; });
    if (medial_voxels == 0)
        return {without_medial_axis(points, grid.size()), !std::isfinite(reach)};
    feature_transform(grid, reach, nearest.site, steps.next());
    FoundSizes found = read_at_interface({grid, VoxelCoordinates(grid), medial, nearest}, points, steps.next());
    found.sizes.medial_voxels = medial_voxels;
    return found;
}

}  // namespace

FeatureSizes local_feature_sizes(const Labelling& labelling, double most, const Run& run)
{
    const Grid& grid = labelling.grid;
    Steps steps(run, {{"sizing: interfaces", 6}, {"sizing: thin parts", 5}, {nullptr, 57}});
    InterfacePoints points(labelling, steps.next());
    if (points.count() == 0)
        return {};
    Array<uint8_t> medial = thin_medial_places(labelling, points, steps.next());
    // A byte per voxel, which only the thin parts need; the arrays below are the peak of this stage.
    points.forget_sides();
    NearestSites nearest{large_array<int32_t>(run, grid.size()), 0};
    const Array<double> reaches = reaches_to_try(grid, points.count(), most);
    Steps tries(steps.next(), Array<Step>(reaches.size(), {nullptr, 1}));
    FoundSizes found;
    for (const double reach : reaches) {
        found = sizes_within(reach, labelling, points, medial, nearest, tries.next());
        if (found.are_certain)
            break;
    }
    return std::move(found.sizes);
}

}  // namespace cleft
