// Puts the figures of a run into one line.
#include "progress_text.hpp"

#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cleft_cli
{
namespace
{

std::string percent_text(double fraction)
{
    // Not rounded: 100 % is the end.
    return std::to_string(static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0))) + " %";
}

std::string left_text(const ProgressFigures& figures)
{
    // An estimate of nothing is no news, as the bar is still there.
    constexpr double kLeast = 0.5;
    return figures.left && *figures.left >= kLeast ? ", " + rough_duration_text(*figures.left) + " left" : "";
}

// Depends on the terminal alone, so that the bar does not change its width when a number gets longer.
std::size_t bar_width(int columns)
{
    constexpr int kBesideBar = 60;  // the numbers, and a stage of usual length
    constexpr int kLeast = 10;
    constexpr int kMost = 30;
    return columns < kBesideBar - kLeast ? 0
                                         : static_cast<std::size_t>(std::clamp(columns - kBesideBar, kLeast, kMost));
}

}  // namespace

std::string duration_text(double seconds)
{
    constexpr int64_t kMinute = 60;
    constexpr int64_t kHour = 3600;
    const auto whole = static_cast<int64_t>(seconds);
    if (whole < kMinute)
        return std::to_string(whole) + " s";
    if (whole < kHour)
        return std::to_string(whole / kMinute) + " min " + std::to_string(whole % kMinute) + " s";
    return std::to_string(whole / kHour) + " h " + std::to_string(whole % kHour / kMinute) + " min";
}

std::string rough_duration_text(double seconds)
{
    constexpr int64_t kMinute = 60;
    const auto in_steps = [&](int64_t step) { return step * std::llround(seconds / static_cast<double>(step)); };
    // Each limit is what would be rounded to the first number of the next row.
    if (seconds < 10)
        return std::to_string(in_steps(1)) + " s";
    if (seconds < 57.5)
        return std::to_string(in_steps(5)) + " s";
    if (seconds < 3570)
        return std::to_string(in_steps(kMinute) / kMinute) + " min";
    return duration_text(static_cast<double>(in_steps(5 * kMinute)));
}

std::string bar_text(const ProgressFigures& figures, int columns)
{
    const std::size_t width = bar_width(columns);
    const auto filled = static_cast<std::size_t>(std::clamp(figures.fraction, 0.0, 1.0) * static_cast<double>(width));
    std::string text;
    if (width > 0)
        text = "[" + std::string(filled, '#') + std::string(width - filled, '.') + "] ";
    text += right(percent_text(figures.fraction), 5) + "  " + duration_text(figures.seconds) + left_text(figures) +
            "  " + figures.stage;
    return text.substr(0, static_cast<std::size_t>(std::max(0, columns)));
}

std::string line_text(const ProgressFigures& figures)
{
    return percent_text(figures.fraction) + " after " + duration_text(figures.seconds) + left_text(figures) + ": " +
           figures.stage;
}

}  // namespace cleft_cli
