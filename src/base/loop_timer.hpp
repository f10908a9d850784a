// Counts the time of loops that threads can share, so that each stage can say how much of its time one thread had
// alone.
#pragma once

#include "base/run.hpp"

#include <chrono>

namespace cleft
{

// Adds the time of its scope, a loop of so many chunks, to Run::loop_time.
class LoopTimer
{
public:
    LoopTimer(const Run& run, int64_t chunks)
        : time_(chunks > 1 ? run.loop_time : nullptr), chunks_(chunks), begin_(std::chrono::steady_clock::now())
    {
    }
    ~LoopTimer()
    {
        if (!time_)
            return;
        const std::chrono::nanoseconds taken = std::chrono::steady_clock::now() - begin_;
        time_->fetch_add(static_cast<int64_t>(shared(chunks_) * static_cast<double>(taken.count())),
                         std::memory_order_relaxed);
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
    const std::chrono::steady_clock::time_point begin_;
};

}  // namespace cleft
