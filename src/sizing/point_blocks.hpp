// Points sorted into blocks of voxels, so that all within a window around one are in the 27 blocks around it.
#pragma once

#include "base/counting_sort.hpp"
#include "base/grid.hpp"
#include "sizing/surface_curvature.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace cleft
{

class PointBlocks
{
public:
    // `width` voxels are the side of a block. A point has a place `x` in the box.
    template <class Point>
    PointBlocks(const Grid& voxels, int width, const Array<Point>& points, const Run& run)
        : size_(width * voxels.spacing)
    {
        for (int a = 0; a < 3; ++a)
            grid_.dims[a] = (voxels.dims[a] + width - 1) / width;
        groups_ = group_by_key<int64_t, int32_t>(run, points.count(), grid_.size(), [&](int64_t i, const auto& give) {
            FixedArray<int32_t, 3> at{};
            for (int a = 0; a < 3; ++a)
                at[a] = std::clamp(static_cast<int32_t>(points[i].x[a] / size_[a]), 0, grid_.dims[a] - 1);
            give(grid_.index(at[0], at[1], at[2]), static_cast<int32_t>(i));
        });
    }

    int64_t count() const { return grid_.size(); }
    // Of a block, along the axes.
    const Vec3& size() const { return size_; }

    template <class Visit>
    void for_each_in(int64_t block, const Visit& visit) const
    {
        for (int64_t n = groups_.start[block]; n < groups_.start[block + 1]; ++n)
            visit(groups_.values[n]);
    }

    template <class Visit>
    void for_each_around(int64_t block, const Visit& visit) const
    {
        const auto i = static_cast<int32_t>(block % grid_.dims[0]);
        const auto j = static_cast<int32_t>(block / grid_.dims[0] % grid_.dims[1]);
        const auto k = static_cast<int32_t>(block / grid_.dims[0] / grid_.dims[1]);
        for (int32_t c = k - 1; c <= k + 1; ++c)
            for (int32_t b = j - 1; b <= j + 1; ++b)
                for (int32_t a = i - 1; a <= i + 1; ++a)
                    if (grid_.has(a, b, c))
                        for_each_in(grid_.index(a, b, c), visit);
    }

private:
    Grid grid_;
    Vec3 size_;
    Groups<int64_t, int32_t> groups_;
};

// What is found at each point. Curvatures hardly change within a block: all of its points that are alike, of one
// interface and one side of it, have that of the first.
template <class Found, class Point, class IsAlike, class FindAt>
Array<Found> found_by_block(const PointBlocks& blocks, const Array<Point>& points, const IsAlike& is_alike,
                            const FindAt& find_at, const Run& run)
{
    constexpr int64_t kBlocksAtOnce = 64;
    Array<Found> out = large_array<Found>(run, points.size());
    parallel_for(run, blocks.count(), kBlocksAtOnce, [&](int64_t begin, int64_t end) {
        Array<std::pair<int32_t, Found>> known;
        for (int64_t block = begin; block < end; ++block) {
            known.clear();
            blocks.for_each_in(block, [&](int32_t i) {
                const auto is_like_it = [&](const auto& first) { return is_alike(points[first.first], points[i]); };
                auto found = std::find_if(known.begin(), known.end(), is_like_it);
                if (found == known.end())
                    found = known.insert(found, {i, find_at(block, points[i])});
                out[i] = found->second;
            });
        }
    });
    return out;
}

}  // namespace cleft
