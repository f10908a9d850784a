// Small helpers that the passes over the voxels share: coordinates of a voxel number, chunks of rows.
#pragma once

#include "base/grid.hpp"
#include "base/parallel.hpp"

#include <algorithm>
#include <cstdint>

namespace cleft
{

// Coordinates of a voxel number by multiplication; an integer division costs as much as the rest of a pass.
// Exact for numbers below 2^31: the half keeps the quotient away from the integers by more than the rounding.
class VoxelCoordinates
{
public:
    explicit VoxelCoordinates(const Grid& grid)
        : row_(grid.dims[0]),
          plane_(int64_t{grid.dims[0]} * grid.dims[1]),
          per_row_(1.0 / grid.dims[0]),
          per_plane_(1.0 / static_cast<double>(plane_))
    {
    }

    FixedArray<int32_t, 3> of(int32_t voxel) const
    {
        const auto k = static_cast<int32_t>((voxel + 0.5) * per_plane_);
        const auto in_plane = static_cast<int32_t>(voxel - k * plane_);
        const auto j = static_cast<int32_t>((in_plane + 0.5) * per_row_);
        CLEFT_ASSERT(in_plane >= j * row_ && in_plane < (j + 1) * row_);
        return {in_plane - j * row_, j, k};
    }

private:
    int32_t row_;
    int64_t plane_;
    double per_row_, per_plane_;
};

inline int64_t row_count(const Grid& grid) { return int64_t{grid.dims[1]} * grid.dims[2]; }

// Rows in a chunk of about 16,000 voxels: enough to make a chunk worth handing out, few enough to cancel soon.
inline int64_t rows_per_chunk(const Grid& grid) { return std::max<int64_t>(1, 16384 / grid.dims[0]); }

// body(chunk, begin, end) over chunks of [0, n), in batches with a report before each.
template <class Body>
void parallel_with_progress(const Run& run, int64_t n, int64_t grain, const Body& body)
{
    // Reports are for the calling thread only. Batches let it report between them, and 16 of them cost no waiting that
    // shows.
    constexpr int64_t kBatches = 16;
    const int64_t chunks = chunk_count(n, grain);
    const int64_t batch = std::max<int64_t>(1, chunk_count(chunks, kBatches));
    for (int64_t first = 0; first < chunks; first += batch) {
        run.report(static_cast<double>(first) / static_cast<double>(chunks));
        const int64_t begin = first * grain;
        const int64_t count = std::min(n, (first + batch) * grain) - begin;
        parallel_chunks(run, count, grain, [&](int64_t chunk, int64_t from, int64_t to) {
            body(first + chunk, begin + from, begin + to);
        });
    }
}

}  // namespace cleft
