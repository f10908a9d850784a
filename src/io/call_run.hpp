// The run of one call of the component: threads, progress and cancelling of its context.
#pragma once

#include "base/run.hpp"
#include "base/team.hpp"
#include "cleft/cleft.h"

#include <chrono>
#include <thread>

namespace cleft::io
{

class CallRun
{
public:
    // `stage`: what is reported before a step has a name.
    CallRun(cleft_context* context, const char* stage)
        : context_(context), team_(cleft_context_threads(context)), stage_(stage)
    {
    }
    CallRun(const CallRun&) = delete;
    CallRun& operator=(const CallRun&) = delete;

    // It must not outlive this object. All but its check() is for the thread that made the call.
    Run run();
    // A call of the core comes next, which is this share of the whole.
    void begin_inner(double share, const char* stage);

private:
    using Clock = std::chrono::steady_clock;

    bool is_cancelled(double end);

    cleft_context* context_;
    Team team_;
    const std::thread::id caller_ = std::this_thread::get_id();
    double fraction_ = 0;
    const char* stage_;
    Clock::time_point last_{};
};

}  // namespace cleft::io
