// A loop over planes and the rows in them where row (plane, row) needs (plane - 1, row + 1) and all that come before:
// the order of a raster scan whose stencil holds all neighbours that it has passed. Several planes are under way at a
// time, each a little behind the one before, and the outcome is that of the serial loop.
#pragma once

#include "base/array.hpp"
#include "sizing/voxel_rows.hpp"

#include <atomic>
#include <thread>

namespace cleft
{

// Planes that are handed out together, between two reports.
// Each plane under way keeps rows of its own, so more would take memory; fewer would leave threads idle.
constexpr int32_t kWavefrontBatch = 16;

// body(plane, row) in the order above. It must not throw: planes that wait for its rows would wait forever.
template <class Body>
void wavefront(const Run& run, int32_t planes, int32_t rows, const Body& body)
{
    for (int32_t first = 0; first < planes; first += kWavefrontBatch) {
        run.report(static_cast<double>(first) / planes);
        const int32_t count = std::min(kWavefrontBatch, planes - first);
        Array<std::atomic<int32_t>> done(count);
        // Chunks are handed out in ascending order, so the plane that a plane waits for has always begun. Hence nothing
        // waits for ever, even with one thread.
        parallel_for(run, count, 1, [&](int64_t p, int64_t) {
            for (int32_t row = 0; row < rows; ++row) {
                if (p > 0) {
                    const auto& before = done[p - 1];
                    // Row + 1 of the plane before must be done, for the stencil reaches one row ahead.
                    while (before.load(std::memory_order_acquire) < std::min(row + 2, rows)) {
                        run.check();  // the plane before may never come: its thread was cancelled
                        std::this_thread::yield();
                    }
                }
                body(first + static_cast<int32_t>(p), row);
                done[p].store(row + 1, std::memory_order_release);
            }
        });
    }
}

}  // namespace cleft
