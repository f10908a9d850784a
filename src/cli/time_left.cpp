// Estimates the time of the whole run as the time so far by the part that is done, and averages this over the last
// tenth of the run. Stages differ a little from their shares of the bar, and a number that jumps helps nobody.
#include "time_left.hpp"

#include <algorithm>
#include <cmath>

namespace cleft_cli
{

std::optional<double> TimeLeft::at(double seconds, double fraction)
{
    // Before that, the start of the program and the first read of a file are most of what has passed.
    constexpr double kFirstSeconds = 1;
    constexpr double kFirstPart = 0.01;
    if (seconds < kFirstSeconds || fraction < kFirstPart)
        return std::nullopt;
    const double now = seconds / std::min(fraction, 1.0);
    constexpr double kLeastWindow = 2;  // seconds
    const double window = std::max(kLeastWindow, seconds / 10);
    const double weight = whole_ ? 1 - std::exp((last_ - seconds) / window) : 1;
    whole_ = (1 - weight) * whole_.value_or(0) + weight * now;
    last_ = seconds;
    return std::max(0.0, *whole_ - seconds);
}

}  // namespace cleft_cli
