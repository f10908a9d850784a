// One line on a terminal that shows how far the work is.
#pragma once

#include <chrono>
#include <string>

namespace cleft_cli
{

class ProgressBar
{
public:
    // Disabled, it draws nothing: --quiet, or standard error is no terminal.
    explicit ProgressBar(bool enabled) : enabled_(enabled) {}
    ~ProgressBar() { clear(); }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    // Draws at most ten times a second.
    // `fraction` is in [0, 1]; `stage` is what the line says.
    void show(double fraction, const std::string& stage);
    // Takes the line off the terminal, so that something else can be printed.
    void clear();

private:
    using Clock = std::chrono::steady_clock;
    bool enabled_;
    bool visible_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point drawn_{};
};

}  // namespace cleft_cli
