// Shows on standard error how far a run is: a bar on a terminal, lines in a log.
#pragma once

#include "line_times.hpp"
#include "progress_plan.hpp"
#include "time_left.hpp"

#include <chrono>
#include <string>
#include <vector>

namespace cleft_cli
{

enum class ProgressStyle { kNone, kBar, kLines, kLateLines };

// `wanted`: auto, bar, lines or none.
ProgressStyle progress_style(const std::string& wanted, bool quiet);

class Progress
{
public:
    Progress(ProgressStyle style, std::vector<Part> parts);
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // Another part of the plan begins; `stage` is what it is called.
    void begin(const std::string& part, const std::string& stage);
    // So much of the part is done, in [0, 1].
    void show(double fraction, const std::string& stage);
    // Takes the bar off the terminal, so that something else can be printed.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    void draw_bar(double fraction, const std::string& stage, double seconds);
    void print_line(double fraction, const std::string& stage, double seconds);

    ProgressStyle style_;
    ProgressPlan plan_;
    LineTimes lines_;
    TimeLeft time_left_;
    bool is_visible_ = false;
    Clock::time_point start_ = Clock::now();
    double drawn_ = 0;  // seconds after the start
};

}  // namespace cleft_cli
