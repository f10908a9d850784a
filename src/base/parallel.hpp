// Loops over threads. The cut into chunks depends on `grain` alone, never on the number of threads, so that a loop
// whose chunks write to separate places (or whose per-chunk results are combined in chunk order) gives the same
// bytes for every thread count.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

namespace cleft
{

inline int64_t chunk_count(int64_t n, int64_t grain) { return (n + grain - 1) / grain; }

// body(chunk, begin, end) for every chunk of `grain` items of [0, n). A cancel is looked for before each chunk.
// If bodies throw, the exception of the lowest chunk that threw is rethrown on the calling thread.
template <class Body>
void parallel_chunks(const Run& run, int64_t n, int64_t grain, const Body& body)
{
    const int64_t chunks = chunk_count(n, grain);
    const int workers = static_cast<int>(std::min<int64_t>(std::max(1, run.threads), chunks));
    // Threads take chunks as they come: which thread has which chunk must not matter, and their times even out.
    std::atomic<int64_t> next{0};
    std::atomic<bool> failed{false};
    Array<std::exception_ptr> errors(std::max(1, workers));
    Array<int64_t> error_chunk(errors.size(), INT64_MAX);
    const auto work = [&](int worker) {
        int64_t chunk = 0;
        try {
            while (!failed.load(std::memory_order_relaxed) && (chunk = next.fetch_add(1)) < chunks) {
                run.check();
                body(chunk, chunk * grain, std::min(n, (chunk + 1) * grain));
            }
        } catch (...) {
            errors[worker] = std::current_exception();
            error_chunk[worker] = chunk;
            failed = true;
        }
    };
    std::vector<std::thread> threads;
    for (int t = 1; t < workers; ++t) {
        try {
            threads.emplace_back(work, t);
        } catch (const std::system_error&) {
            break;  // no more threads to be had: the others do the work
        }
    }
    if (chunks > 0)
        work(0);
    for (auto& thread : threads)
        thread.join();
    // The error of the lowest chunk, and not of the first thread that failed, so that users read the same sentence each
    // time. All lower chunks have begun by then, since chunks are handed out in order.
    const auto first = std::min_element(error_chunk.begin(), error_chunk.end()) - error_chunk.begin();
    if (errors[first])
        std::rethrow_exception(errors[first]);
}

// body(begin, end) for every chunk.
template <class Body>
void parallel_for(const Run& run, int64_t n, int64_t grain, const Body& body)
{
    parallel_chunks(run, n, grain, [&](int64_t, int64_t begin, int64_t end) { body(begin, end); });
}

}  // namespace cleft
