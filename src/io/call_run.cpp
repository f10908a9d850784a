// Asks the context for a cancel, by reports alone: the component sees no more of it than any program.
#include "io/call_run.hpp"

#include "io/create_volume.hpp"

#include <algorithm>

namespace cleft::io
{

Run CallRun::run()
{
    Run run;
    run.threads = cleft_context_threads(context_);
    run.team = &team_;
    run.progress = [this](double fraction, const char* stage) {
        // A bar that goes back looks like a fault.
        fraction_ = std::clamp(fraction, fraction_, 1.0);
        stage_ = stage ? stage : stage_;
        return is_cancelled(fraction_);
    };
    run.repeat_progress = [this] {
        // As in the core: a twentieth of a second feels instant, and callbacks run on the thread that made the call.
        constexpr std::chrono::milliseconds kBetweenReports{50};
        return std::this_thread::get_id() == caller_ && Clock::now() - last_ > kBetweenReports &&
               is_cancelled(fraction_);
    };
    run.on_warning = [this](const std::string& sentence) { report(context_, sentence); };
    return run;
}

void CallRun::begin_inner(double share, const char* stage)
{
    // The core has threads of its own, and memory for their stacks is memory.
    team_.dismiss();
    const double end = std::min(1.0, fraction_ + share);
    stage_ = stage;
    if (is_cancelled(end))
        throw Error(CLEFT_ERROR_CANCELLED, "the run was cancelled");
    fraction_ = end;
}

bool CallRun::is_cancelled(double end)
{
    const bool cancelled = cleft_context_report(context_, fraction_, end, stage_) != CLEFT_OK;
    last_ = Clock::now();
    return cancelled;
}

}  // namespace cleft::io
