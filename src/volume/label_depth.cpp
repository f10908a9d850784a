// How far each voxel lies inside its material, in the maximum norm: the radius of the block around it that holds one
// material. Where it is at least the kernel's reach, a sample needs one look-up.
#include "volume/label_depth.hpp"

#include "base/parallel.hpp"
#include "volume/chessboard.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// out[x] = 0 where one of the 26 neighbours differs, else the greatest depth. Rows outside the grid equal the nearest.
template <class Label>
void mark_band(const LabelMap<Label>& map, int32_t y, int32_t z, uint8_t* out)
{
    const auto& dims = map.grid.dims;
    const int32_t nx = dims[0];
    const Label* own = map.material.data() + map.grid.index(0, y, z);
    std::fill(out, out + nx, uint8_t{0});
    for (int32_t dz = -1; dz <= 1; ++dz)
        for (int32_t dy = -1; dy <= 1; ++dy) {
            const Label* row =
                map.material.data() + map.grid.index(0, mirrored(y + dy, dims[1]), mirrored(z + dz, dims[2]));
            for (int32_t x = 0; x < nx; ++x)
                out[x] = static_cast<uint8_t>(out[x] | (row[x] != own[x]));
            for (int32_t x = 1; x < nx; ++x)
                out[x] = static_cast<uint8_t>(out[x] | (row[x - 1] != own[x]));
            for (int32_t x = 0; x + 1 < nx; ++x)
                out[x] = static_cast<uint8_t>(out[x] | (row[x + 1] != own[x]));
        }
    for (int32_t x = 0; x < nx; ++x)
        out[x] = static_cast<uint8_t>(out[x] ? 0 : kDepthGreatest);
}

}  // namespace

template <class Label>
void find_depths(LabelMap<Label>& map, const Run& run)
{
    const Grid& grid = map.grid;
    const auto nx = grid.dims[0], ny = grid.dims[1], nz = grid.dims[2];  // lambdas of C++17 capture no bindings
    const int64_t size = grid.size() + kLanes;
    map.weight.assign(size, kWeightOne);
    map.code.assign(size, 0);
    uint8_t* depth = map.code.data();
    parallel_for(run, int64_t{ny} * nz, 16, [&](int64_t begin, int64_t end) {
        for (int64_t row = begin; row < end; ++row)
            mark_band(map, static_cast<int32_t>(row % ny), static_cast<int32_t>(row / ny), depth + row * nx);
    });
    chessboard_distance(grid, depth, kDepthGreatest, run);
    parallel_for(run, grid.size(), int64_t{1} << 16, [&](int64_t begin, int64_t end) {
        for (int64_t v = begin; v < end; ++v)
            depth[v] = static_cast<uint8_t>(depth[v] == 0 ? 0 : depth[v] + kBumpGreatest);
    });
}

template void find_depths(LabelMap<uint8_t>&, const Run&);
template void find_depths(LabelMap<uint16_t>&, const Run&);

}  // namespace cleft
