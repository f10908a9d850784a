// A stage of the work and the steps that it consists of: one timer, one bar, and one list of the shares of time that
// the steps take.
#pragma once

#include "base/array.hpp"
#include "base/stage_timer.hpp"

#include <utility>

namespace cleft
{

// `name`: what the user reads while the step runs; null: what the steps inside of it are called, or the one before.
// `share`: of the time, in any unit. The shares in the stages are what AAL and a head of 135 million voxels took;
// change one where a stage changes its speed. A wrong one makes the bar uneven, and no result.
struct Step {
    const char* name;
    double share;
};

// Steps one after the other. Each gets a run of its own, whose progress from 0 to 1 is the share of the step.
class Steps
{
public:
    Steps(Run run, Array<Step> steps) : run_(std::move(run)), steps_(std::move(steps))
    {
        for (const Step& step : steps_)
            all_ += step.share;
        CLEFT_ASSERT(all_ > 0);
    }

    // The run of the step that begins now. A step with a name reports it.
    Run next()
    {
        CLEFT_ASSERT(at_ < steps_.size());
        const Step step = steps_[at_++];
        // Shares are fractions of all steps from the beginning, so the bar never goes back, even where a step is left
        // out.
        const double begin = done_ / all_, share = step.share / all_;
        done_ += step.share;
        Run part = run_;
        if (run_.progress)
            part.progress = [outer = run_.progress, begin, share, name = step.name](double fraction,
                                                                                    const char* inner) {
                return outer(begin + share * fraction, inner ? inner : name);
            };
        if (step.name)
            part.report(0);
        return part;
    }

private:
    const Run run_;
    Array<Step> steps_;
    size_t at_ = 0;
    double all_ = 0, done_ = 0;
};

// Steps that are timed: NAME.seconds, NAME.cpu_seconds and NAME.peak_bytes are noted at the end of the scope.
class Stage : public Steps
{
public:
    Stage(const Run& run, const char* name, Array<Step> steps) : Steps(run, std::move(steps)), timer_(run, name) {}

private:
    StageTimer timer_;
};

}  // namespace cleft
