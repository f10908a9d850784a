// Counts the time of loops that threads can share, so that each stage can say how much of its time one thread had
// alone.
#pragma once

#include "base/process_figures.hpp"
#include "base/run.hpp"

namespace cleft
{

// Adds the processor time of its thread in its scope, a loop of so many chunks, to Run::loop_time.
class LoopTimer
{
public:
    LoopTimer(const Run& run, int64_t chunks)
        : time_(chunks > 1 ? run.loop_time : nullptr), chunks_(chunks), begin_(time_ ? thread_cpu_seconds() : 0)
    {
    }
    ~LoopTimer()
    {
        if (!time_)
            return;
        const double taken = shared(chunks_) * (thread_cpu_seconds() - begin_);
        time_->fetch_add(static_cast<int64_t>(1e9 * taken), std::memory_order_relaxed);
    }
    LoopTimer(const LoopTimer&) = delete;
    LoopTimer& operator=(const LoopTimer&) = delete;

private:
    // A loop of c chunks takes at least a c-th of the time, however many threads there are. It counts as a loop with
    // that share for one thread and the rest for all, which takes as long on this many threads.
    static double shared(int64_t chunks)
    {
        constexpr double kThreads = 16;
        const auto most = static_cast<double>(chunks);
        return most < kThreads ? (1 - 1 / most) / (1 - 1 / kThreads) : 1.0;
    }

    std::atomic<int64_t>* const time_;
    const int64_t chunks_;
    const double begin_;
};

}  // namespace cleft
