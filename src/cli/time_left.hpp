// How long a run still takes, as far as its progress tells.
#pragma once

#include <optional>

namespace cleft_cli
{

// Knows no clock: the caller says how many seconds have passed.
class TimeLeft
{
public:
    // Seconds left, when `fraction` of the work is done after `seconds`. Empty while that says too little.
    std::optional<double> at(double seconds, double fraction);

private:
    std::optional<double> whole_;  // seconds of the run, averaged
    double last_ = 0;              // when it was asked last
};

}  // namespace cleft_cli
