// Loops over threads. The cut into chunks depends on `grain` alone, never on the number of threads, so that a loop
// whose chunks write to separate places (or whose per-chunk results are combined in chunk order) gives the same
// bytes for every thread count.
#pragma once

#include "base/array.hpp"
#include "base/loop_timer.hpp"
#include "base/run.hpp"
#include "base/team.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>

namespace cleft
{

inline int64_t chunk_count(int64_t n, int64_t grain) { return (n + grain - 1) / grain; }

// What workers failed with. Each fails once at most.
class ChunkErrors
{
public:
    explicit ChunkErrors(int workers) : errors_(workers), chunks_(workers, INT64_MAX) {}

    bool any() const { return any_.load(std::memory_order_relaxed); }
    // Keeps the exception that is being handled.
    void keep(int worker, int64_t chunk)
    {
        errors_[worker] = std::current_exception();
        chunks_[worker] = chunk;
        any_ = true;
    }
    // The error of the lowest chunk, and not of the first thread that failed, so that users read the same sentence each
    // time. All lower chunks have begun by then, since chunks are handed out in order.
    void rethrow_first() const
    {
        const auto first = std::min_element(chunks_.begin(), chunks_.end()) - chunks_.begin();
        if (errors_[first])
            std::rethrow_exception(errors_[first]);
    }

private:
    std::atomic<bool> any_{false};
    Array<std::exception_ptr> errors_;
    Array<int64_t> chunks_;
};

// work(worker) for 0 to count - 1, on as many threads or fewer: 0 is on the calling one. Returns when all are done.
inline void run_workers(const Run& run, int count, const Team::Work& work)
{
    if (count == 1)
        work(0);
    else if (!run.team || !run.team->run(count, work))
        Team(count).run(count, work);
}

// How many workers a loop has at most: 0 to worker_count - 1 are their numbers.
inline int worker_count(const Run& run) { return std::max(1, run.threads); }

// body(worker, chunk, begin, end) for every chunk of `grain` items of [0, n). A worker has one chunk at a time, so what
// is kept by worker needs no lock. Which worker has which chunk changes from run to run, and must not matter.
// A cancel is looked for before each chunk. If bodies throw, the exception of the lowest chunk that threw is rethrown
// on the calling thread.
template <class Body>
void parallel_chunks_by_worker(const Run& run, int64_t n, int64_t grain, const Body& body)
{
    const int64_t chunks = chunk_count(n, grain);
    if (chunks == 0)
        return;
    const LoopTimer timer(run, chunks);
    const int workers = static_cast<int>(std::min<int64_t>(worker_count(run), chunks));
    // Threads take chunks as they come: which thread has which chunk must not matter, and their times even out.
    std::atomic<int64_t> next{0};
    ChunkErrors errors(workers);
    const auto work = [&](int worker) {
        int64_t chunk = 0;
        try {
            while (!errors.any() && (chunk = next.fetch_add(1)) < chunks) {
                run.check();
                body(worker, chunk, chunk * grain, std::min(n, (chunk + 1) * grain));
            }
        } catch (...) {
            errors.keep(worker, chunk);
        }
    };
    run_workers(run, workers, std::ref(work));  // a copy would ask for memory
    errors.rethrow_first();
}

// body(chunk, begin, end) for every chunk.
template <class Body>
void parallel_chunks(const Run& run, int64_t n, int64_t grain, const Body& body)
{
    parallel_chunks_by_worker(run, n, grain,
                              [&](int, int64_t chunk, int64_t begin, int64_t end) { body(chunk, begin, end); });
}

// body(begin, end) for every chunk.
template <class Body>
void parallel_for(const Run& run, int64_t n, int64_t grain, const Body& body)
{
    parallel_chunks(run, n, grain, [&](int64_t, int64_t begin, int64_t end) { body(begin, end); });
}

}  // namespace cleft
