// Tells the caller's callback how far a call is.
#pragma once

#include "base/run.hpp"
#include "capi/handles.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

namespace cleft::capi
{

class Reporter
{
public:
    // `stage`: what is reported before a stage within the call has a name.
    Reporter(cleft_context& context, const char* stage) : context_(context), stage_(stage) {}

    // True if the callback asks to cancel. A stage that looks twice does not go back. Null: the stage before.
    bool report(double fraction, const char* stage)
    {
        // Callers draw bars, and a bar that goes back looks like a fault. Stages that repeat their work report less
        // than before.
        fraction_ = std::clamp(fraction, fraction_, 1.0);
        stage_ = stage ? stage : stage_;
        return call();
    }

    // Says the same again if the last time was long ago, so that a callback that cancels has its say within loops that
    // take longer than that. Nothing on other threads than the caller's.
    bool repeat()
    {
        // Callers in Python, Java and C# may run a callback only on the thread that made the call.
        return std::this_thread::get_id() == caller_ && Clock::now() - last_ > kPatience && call();
    }

private:
    using Clock = std::chrono::steady_clock;
    // An answer to Ctrl-C within a tenth of a second feels instant. More calls would cost callers in slow languages.
    static constexpr std::chrono::milliseconds kPatience{50};

    bool call()
    {
        // From here on the context answers calls of the callback with CLEFT_ERROR_BUSY.
        const Occupancy::Callback callback(context_.occupancy);
        const double begin = context_.part_begin, end = context_.part_end;
        const bool cancel = context_.progress(begin + (end - begin) * fraction_, stage_, context_.progress_user) != 0;
        // After the callback: a slow one must not be due again at once.
        last_ = Clock::now();
        // It may have asked by cleft_context_cancel(), and nobody looks after the last report.
        return cancel || context_.cancel;
    }

    cleft_context& context_;
    const std::thread::id caller_ = std::this_thread::get_id();
    double fraction_ = 0;
    const char* stage_;
    Clock::time_point last_;
};

}  // namespace cleft::capi
