// What a running stage may use of its caller: threads, progress, cancel, warnings and metrics.
#pragma once

#include "base/error.hpp"
#include "base/metrics.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

namespace cleft
{

class Team;

struct Run {
    int threads = 1;
    Team* team = nullptr;  // has the threads of loops; null: each loop makes its own
    // Called on the calling thread only; true asks to cancel. A stage of null is the one before.
    std::function<bool(double fraction, const char* stage)> progress;
    // May be called on any thread, at any time: repeats the last progress if it is due; true asks to cancel.
    std::function<bool()> repeat_progress;
    std::function<void(const std::string& sentence)> on_warning;
    const std::atomic<bool>* cancel = nullptr;  // may be set from any thread
    Metrics* metrics = nullptr;
    // Nanoseconds that the calling thread has worked in loops that threads can share, see LoopTimer.
    std::atomic<int64_t>* loop_time = nullptr;

    bool cancelled() const { return cancel && cancel->load(std::memory_order_relaxed); }

    // May be called from any thread; throws when a cancel was asked for.
    void check() const
    {
        if (cancelled() || (repeat_progress && repeat_progress()))
            throw Error(CLEFT_ERROR_CANCELLED, "the run was cancelled");
    }

    // check() at every `period`-th item of a loop.
    template <typename Index>  // signed or not, as the loop counts
    void check_at(Index item, int64_t period = 1 << 16) const
    {
        if (int64_t(item) % period == 0)
            check();
    }

    // On the calling thread only: fraction in [0, 1] of the named stage; null: of the one named before.
    void report(double fraction, const char* stage = nullptr) const
    {
        if (cancelled() || (progress && progress(fraction, stage)))
            throw Error(CLEFT_ERROR_CANCELLED, "the run was cancelled");
    }

    // body(i) for i in [0, n), with a report now and then. On the calling thread only.
    template <class Body>
    void for_each(int64_t n, const Body& body) const
    {
        constexpr int64_t kPeriod = 128;  // of items that take some microseconds or more
        for (int64_t i = 0; i < n; ++i) {
            if (i % kPeriod == 0)
                report(static_cast<double>(i) / static_cast<double>(n));
            body(i);
        }
    }

    // On the calling thread only, since figures are kept in the order in which they come.
    void note(const std::string& name, double value) const
    {
        if (metrics)
            metrics->set(name, value);
    }

    // On the calling thread only: it ends in a callback of the user.
    void warn(const std::string& sentence) const
    {
        if (on_warning)
            on_warning(sentence);
    }
};

}  // namespace cleft
