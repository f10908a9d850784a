// The distance in the maximum norm by two raster sweeps over the voxels. Depths of label maps and of blocks of
// indicator functions come from it.
#include "volume/chessboard.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// distance[x] = min(distance[x], 1 + min(other[x - 1 .. x + 1]))
// Three plain loops, none with a condition inside, so that compilers can vectorize them.
void relax_from_row(uint8_t* distance, const uint8_t* other, int32_t nx)
{
    const auto relax = [](uint8_t d, uint8_t o) { return std::min(d, static_cast<uint8_t>(o + 1)); };
    for (int32_t x = 0; x < nx; ++x)
        distance[x] = relax(distance[x], other[x]);
    for (int32_t x = 1; x < nx; ++x)
        distance[x] = relax(distance[x], other[x - 1]);
    for (int32_t x = 0; x + 1 < nx; ++x)
        distance[x] = relax(distance[x], other[x + 1]);
}

void relax_along_row(uint8_t* distance, int32_t nx, int step, int greatest)
{
    // The distance on the way along the row is kept in a register: each voxel needs the one before.
    int last = greatest;
    for (int32_t i = 0; i < nx; ++i) {
        uint8_t& d = distance[step > 0 ? i : nx - 1 - i];
        last = std::min<int>(d, last + 1);
        d = static_cast<uint8_t>(last);
    }
}

// One plane of a sweep in the direction `step`, after the plane before it.
void sweep_plane(const Grid& grid, uint8_t* distance, int32_t z, int step, int greatest)
{
    const auto [nx, ny, nz] = grid.dims;
    const int32_t plane_before = z - step;
    for (int32_t i = 0; i < ny; ++i) {
        const int32_t y = step > 0 ? i : ny - 1 - i;
        uint8_t* row = distance + grid.index(0, y, z);
        if (plane_before >= 0 && plane_before < nz)
            for (int32_t other = std::max(0, y - 1); other <= std::min(ny - 1, y + 1); ++other)
                relax_from_row(row, distance + grid.index(0, other, plane_before), nx);
        const int32_t row_before = y - step;
        if (row_before >= 0 && row_before < ny)
            relax_from_row(row, distance + grid.index(0, row_before, z), nx);
        relax_along_row(row, nx, step, greatest);
    }
}

}  // namespace

// Two sweeps, each over the 13 neighbours that come before, are exact in this norm.
void chessboard_distance(const Grid& grid, uint8_t* distance, int greatest, const Run& run)
{
    // One less than the greatest byte: a sweep adds 1 before it takes the minimum, and 255 + 1 would become 0.
    CLEFT_ASSERT(greatest <= 254);
    const int32_t nz = grid.dims[2];
    for (int32_t z = 0; z < nz; ++z) {
        run.report(0.5 * z / nz);
        sweep_plane(grid, distance, z, 1, greatest);
    }
    for (int32_t z = nz - 1; z >= 0; --z) {
        run.report(1 - 0.5 * (z + 1) / nz);
        sweep_plane(grid, distance, z, -1, greatest);
    }
}

}  // namespace cleft
