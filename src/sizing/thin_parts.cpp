// Gives thin parts a place of the medial axis by counting voxels. Interface points there are too near to each other to
// show opposite sides.
#include "sizing/thin_parts.hpp"

#include "base/touched_array.hpp"
#include "sizing/medial_axis.hpp"

namespace cleft
{
namespace
{

class ThinParts
{
public:
    ThinParts(const Grid& grid, const InterfacePoints& points) : grid_(grid), points_(points), stride_(grid.strides())
    {
    }

    // The place of the medial axis that a voxel holds, or 0.
    uint8_t place(RowWindow& window, const FixedArray<int32_t, 3>& at) const
    {
        const int64_t voxel = grid_.index(at[0], at[1], at[2]);
        if (is_single(voxel))
            return singles_prevail(window, at) ? pack_medial({0, 0, 0}) : 0;
        // A sheet of two voxels has one pair, and normals that show its sides (medial_axis.cpp). Rods of two voxels
        // have two pairs, and normals that point aslant.
        int pairs = 0;
        int towards_next = -1;
        for (int a = 0; a < 3; ++a) {
            const int end = end_of_pair(voxel, at, a);
            pairs += end != 0;
            if (end > 0)
                towards_next = a;
        }
        // Only the first voxel of a pair holds the place, which lies half-way to the second.
        if (pairs < 2 || towards_next < 0 || has_inner_neighbour(window, at))
            return 0;
        return pack_medial(towards_next, 0.5);
    }

private:
    // Whether the material ends on both sides of the voxel along some axis. The box ends nothing.
    bool is_single(int64_t voxel) const
    {
        const int sides = points_.sides(voxel);
        return (sides & sides >> 1 & 0x15) != 0;
    }

    // Whether the voxel is the first (1) or the second (-1) of a pair of voxels along an axis between which and beyond
    // which the material ends on both sides, or not (0).
    int end_of_pair(int64_t voxel, const FixedArray<int32_t, 3>& at, int axis) const
    {
        const auto ends = [&](int64_t v, int side) { return (points_.sides(v) >> (2 * axis + side) & 1) != 0; };
        if (ends(voxel, 0) && at[axis] + 1 < grid_.dims[axis] && ends(voxel + stride_[axis], 1))
            return 1;
        if (ends(voxel, 1) && at[axis] > 0 && ends(voxel - stride_[axis], 0))
            return -1;
        return 0;
    }

    // visit(neighbour) for the 26 neighbours that are of the voxel's material.
    template <class Visit>
    void for_each_neighbour(RowWindow& window, const FixedArray<int32_t, 3>& at, const Visit& visit) const
    {
        const auto [i, j, k] = at;
        const Material own = window.row(j, k)[i];
        for (int32_t z = std::max(0, k - 1); z <= std::min(k + 1, grid_.dims[2] - 1); ++z)
            for (int32_t y = std::max(0, j - 1); y <= std::min(j + 1, grid_.dims[1] - 1); ++y) {
                const Material* row = window.row(y, z);
                for (int32_t x = std::max(0, i - 1); x <= std::min(i + 1, grid_.dims[0] - 1); ++x)
                    if (row[x] == own && (x != i || y != j || z != k))
                        visit(grid_.index(x, y, z));
            }
    }

    // Single voxels count as thin where at least half of their neighbours are single too: in sheets and rods, not where
    // they stick out of a thicker body, as on the caps of a sphere.
    bool singles_prevail(RowWindow& window, const FixedArray<int32_t, 3>& at) const
    {
        int balance = 0;
        for_each_neighbour(window, at, [&](int64_t neighbour) { balance += is_single(neighbour) ? 1 : -1; });
        return balance >= 0;
    }

    bool has_inner_neighbour(RowWindow& window, const FixedArray<int32_t, 3>& at) const
    {
        bool found = false;
        for_each_neighbour(window, at, [&](int64_t neighbour) { found = found || points_.sides(neighbour) == 0; });
        return found;
    }

    const Grid& grid_;
    const InterfacePoints& points_;
    FixedArray<int64_t, 3> stride_;
};

}  // namespace

Array<uint8_t> thin_medial_places(const Labelling& labelling, const InterfacePoints& points, const Run& run)
{
    const Grid& grid = labelling.grid;
    const ThinParts parts(grid, points);
    Array<uint8_t> medial = large_array<uint8_t>(run, grid.size());
    parallel_with_progress(run, row_count(grid), rows_per_chunk(grid), [&](int64_t, int64_t begin, int64_t end) {
        RowWindow window(labelling);
        for (int64_t row = begin; row < end; ++row) {
            const auto j = static_cast<int32_t>(row % grid.dims[1]);
            const auto k = static_cast<int32_t>(row / grid.dims[1]);
            for (int32_t i = 0; i < grid.dims[0]; ++i) {
                const int64_t voxel = row * grid.dims[0] + i;
                if (points.sides(voxel) != 0)
                    medial[voxel] = parts.place(window, {i, j, k});
            }
        }
    });
    return medial;
}

}  // namespace cleft
