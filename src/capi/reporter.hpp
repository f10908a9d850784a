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
    explicit Reporter(cleft_context& context) : context_(context) {}

    // True if the callback asks to cancel. A stage that looks twice does not go back. Null: the stage before.
    bool report(double fraction, const char* stage)
    {
        fraction_ = std::clamp(fraction, fraction_, 1.0);
        stage_ = stage ? stage : stage_;
        return stage_ && call();
    }

    // Says the same again if the last time was long ago, so that a callback that cancels has its say within loops that
    // take longer than that. Nothing on other threads than the caller's.
    bool repeat()
    {
        return stage_ && std::this_thread::get_id() == caller_ && Clock::now() - last_ > kPatience && call();
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds kPatience{50};

    bool call()
    {
        const Occupancy::Callback callback(context_.occupancy);
        const bool cancel = context_.progress(fraction_, stage_, context_.progress_user) != 0;
        last_ = Clock::now();
        return cancel;
    }

    cleft_context& context_;
    const std::thread::id caller_ = std::this_thread::get_id();
    double fraction_ = 0;
    const char* stage_ = nullptr;
    Clock::time_point last_;
};

}  // namespace cleft::capi
