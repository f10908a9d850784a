// The first two distance transforms of section 3 of the paper: from the interfaces to the medial axis, and back.
#include "sizing/feature_size.hpp"

#include "base/stage.hpp"
#include "sizing/feature_transform.hpp"
#include "sizing/medial_axis.hpp"
#include "sizing/thin_parts.hpp"

#include <cmath>

namespace cleft
{
namespace
{

// nearest[v] = v where is_site(v), else -1; returns the number of sites.
template <class IsSite>
int64_t mark_sites(Array<int32_t>& nearest, const IsSite& is_site)
{
    int64_t count = 0;
    for (int32_t v = 0; v < nearest.count(); ++v) {
        const bool site = is_site(v);
        nearest[v] = site ? v : -1;
        count += site;
    }
    return count;
}

struct MedialAxis {
    const Grid& grid;
    VoxelCoordinates coordinates;
    const Array<uint8_t>& held;
    const Array<int32_t>& nearest;  // medial voxel

    // The distance from x, a point in the voxel (i, j, k), which the nearest medial voxel of the voxel or of one of its
    // neighbours holds.
    // The transform is exact for centres of voxels, but places of the axis lie up to a step beside them. So another
    // candidate may be nearer, and it is nearly always that of a neighbour.
    float distance(int32_t i, int32_t j, int32_t k, const Vec3& x) const
    {
        const FixedArray<int32_t, 3> at{i, j, k};
        const int64_t voxel = grid.index(i, j, k);
        const FixedArray<int64_t, 3> stride = grid.strides();
        FixedArray<int32_t, 7> candidates{nearest[voxel]};
        size_t count = 1;
        for (int a = 0; a < 3; ++a) {
            if (at[a] > 0)
                candidates[count++] = nearest[voxel - stride[a]];
            if (at[a] + 1 < grid.dims[a])
                candidates[count++] = nearest[voxel + stride[a]];
        }
        CLEFT_ASSERT(candidates[0] >= 0);
        double least = INFINITY;
        for (size_t c = 0; c < count; ++c) {
            if (c > 0 && candidates[c] == candidates[c - 1])
                continue;
            const auto site = coordinates.of(candidates[c]);
            const Vec3 place =
                grid.centre(site[0], site[1], site[2]) + medial_offset(held[candidates[c]], grid.spacing);
            least = std::min(least, (place - x).squaredNorm());
        }
        return static_cast<float>(std::sqrt(least));
    }
};

// The interface voxels of some rows with their feature size.
FeatureSizes sizes_of_rows(const MedialAxis& axis, const InterfacePoints& points, int64_t begin, int64_t end)
{
    const Grid& grid = axis.grid;
    FeatureSizes found;
    for (int64_t row = begin; row < end; ++row) {
        const auto j = static_cast<int32_t>(row % grid.dims[1]);
        const auto k = static_cast<int32_t>(row / grid.dims[1]);
        for (int32_t i = 0; i < grid.dims[0]; ++i) {
            const int64_t voxel = row * grid.dims[0] + i;
            if (!points.contains(voxel))
                continue;
            const auto& offset = points[voxel].offset;
            const Vec3 x = grid.centre(i, j, k) + Vec3(offset[0], offset[1], offset[2]);
            found.voxel.push_back(static_cast<int32_t>(voxel));
            found.size.push_back(axis.distance(i, j, k, x));
        }
    }
    return found;
}

FeatureSizes read_at_interface(const MedialAxis& axis, const InterfacePoints& points, const Run& run)
{
    const int64_t rows = row_count(axis.grid);
    const int64_t grain = rows_per_chunk(axis.grid);
    Array<FeatureSizes> parts(chunk_count(rows, grain));
    parallel_with_progress(run, rows, grain, [&](int64_t chunk, int64_t begin, int64_t end) {
        parts[chunk] = sizes_of_rows(axis, points, begin, end);
    });
    FeatureSizes all;
    all.voxel.reserve(points.count());
    all.size.reserve(points.count());
    // In the order of the chunks, so that voxels ascend for any number of threads.
    for (FeatureSizes& part : parts) {
        all.voxel.insert(all.voxel.end(), part.voxel.begin(), part.voxel.end());
        all.size.insert(all.size.end(), part.size.begin(), part.size.end());
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

}  // namespace

FeatureSizes local_feature_sizes(const Labelling& labelling, const Run& run)
{
    const Grid& grid = labelling.grid;
    Steps steps(run, {{"sizing: interfaces", 6},
                      {"sizing: thin parts", 5},
                      {"sizing: distances from interfaces", 14},
                      {"sizing: medial axis", 26},
                      {"sizing: distances from the medial axis", 13},
                      {"sizing: feature sizes", 4}});
    InterfacePoints points(labelling, steps.next());
    if (points.count() == 0)
        return {};
    Array<uint8_t> medial = thin_medial_places(labelling, points, steps.next());
    // A byte per voxel, which only the thin parts need; the arrays below are the peak of this stage.
    points.forget_sides();
    Array<int32_t> nearest(grid.size());
    mark_sites(nearest, [&](int32_t v) { return points.contains(v); });
    feature_transform(grid, nearest, steps.next());
    add_medial_places(labelling, points, nearest, medial, steps.next());
    // The same array serves both transforms, since the second needs only `medial` of the first.
    const int64_t medial_voxels = mark_sites(nearest, [&](int32_t v) { return medial[v] != 0; });
    if (medial_voxels == 0)
        return without_medial_axis(points, grid.size());
    feature_transform(grid, nearest, steps.next());
    FeatureSizes sizes = read_at_interface({grid, VoxelCoordinates(grid), medial, nearest}, points, steps.next());
    sizes.medial_voxels = medial_voxels;
    return sizes;
}

}  // namespace cleft
