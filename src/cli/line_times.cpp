// Decides by the time since the last line.
#include "line_times.hpp"

#include <algorithm>

namespace cleft_cli
{

bool LineTimes::is_due(double seconds, const std::string& stage)
{
    // Some stages follow each other at once, and by turns.
    constexpr double kBetweenStages = 1;
    // Within a stage: a tenth of the time so far, between these. Batch systems take jobs for dead after some minutes of
    // silence.
    constexpr double kOften = 10;
    constexpr double kSeldom = 60;
    if (seconds < first_)
        return false;
    const double between = stage == stage_ ? std::clamp(seconds / 10, kOften, kSeldom) : kBetweenStages;
    if (!stage_.empty() && seconds - last_ < between)
        return false;
    last_ = seconds;
    stage_ = stage;
    return true;
}

}  // namespace cleft_cli
