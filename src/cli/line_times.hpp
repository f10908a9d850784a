// When a log gets a line about the progress of a run.
#pragma once

#include <string>

namespace cleft_cli
{

// Often enough that nobody takes the run for dead, and seldom enough that the log stays short: a line where a stage
// begins, and within a long stage one every ten seconds, later every minute.
class LineTimes
{
public:
    // No line before `first` seconds have passed.
    explicit LineTimes(double first) : first_(first) {}

    // Is a line due, `seconds` after the run began? The answer true is taken for a line that is printed.
    bool is_due(double seconds, const std::string& stage);

private:
    double first_;
    double last_ = 0;
    std::string stage_;  // of the last line; "": there was none
};

}  // namespace cleft_cli
