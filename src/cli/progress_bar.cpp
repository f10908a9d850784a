// Draws the progress bar on standard error, so that standard output stays free for results.
#include "progress_bar.hpp"

#include "text.hpp"

#include <algorithm>
#include <cstdio>

namespace cleft_cli
{

void ProgressBar::show(double fraction, const std::string& stage)
{
    const auto now = Clock::now();
    // The first line is drawn at once; a stage of seconds should show its name.
    if (!enabled_ || (visible_ && now - drawn_ < std::chrono::milliseconds(100)))
        return;
    drawn_ = now;
    visible_ = true;
    // With numbers and the name of a stage the line stays below 80 columns.
    const int width = 30;
    const double part = std::clamp(fraction, 0.0, 1.0);
    const auto filled = static_cast<std::size_t>(part * width);
    const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
    const double seconds = std::chrono::duration<double>(now - start_).count();
    // \033[K clears what a longer line left behind.
    std::fprintf(stderr, "\r[%s] %3.0f %%  %s  %s\033[K", bar.c_str(), 100 * part, seconds_text(seconds).c_str(),
                 stage.c_str());
    std::fflush(stderr);
}

void ProgressBar::clear()
{
    if (!visible_)
        return;
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
    visible_ = false;
}

}  // namespace cleft_cli
