// Draws on standard error, so that standard output stays free for results.
#include "progress.hpp"

#include "program.hpp"
#include "progress_text.hpp"
#include "terminal.hpp"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace cleft_cli
{
namespace
{

// Runs of scripts are mostly shorter, and what they print stays as it is.
constexpr double kSilentSeconds = 10;

}  // namespace

ProgressStyle progress_style(const std::string& wanted, bool quiet)
{
    if (quiet || wanted == "none")
        return ProgressStyle::kNone;
    if (wanted == "bar" || (wanted == "auto" && redraws_lines(STDERR_FILENO)))
        return ProgressStyle::kBar;
    return wanted == "lines" ? ProgressStyle::kLines : ProgressStyle::kLateLines;
}

Progress::Progress(ProgressStyle style, std::vector<Part> parts)
    : style_(style), plan_(std::move(parts)), lines_(style == ProgressStyle::kLateLines ? kSilentSeconds : 0)
{
}

void Progress::begin(const std::string& part, const std::string& stage)
{
    plan_.begin(part);
    show(0, stage);
}

void Progress::show(double fraction, const std::string& stage)
{
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    const double done = plan_.at(fraction);
    if (style_ == ProgressStyle::kBar)
        draw_bar(done, stage, seconds);
    else if (style_ != ProgressStyle::kNone)
        print_line(done, stage, seconds);
}

void Progress::draw_bar(double fraction, const std::string& stage, double seconds)
{
    // The first line is drawn at once; a stage of seconds should show its name.
    constexpr double kBetween = 0.1;
    if (is_visible_ && seconds - drawn_ < kBetween)
        return;
    drawn_ = seconds;
    is_visible_ = true;
    // Some terminals begin a new line behind the last column.
    const std::string text =
        bar_text({fraction, seconds, time_left_.at(seconds, fraction), stage}, terminal_columns(STDERR_FILENO) - 1);
    // \033[K clears what a longer line left behind.
    std::fprintf(stderr, "\r%s\033[K", text.c_str());
    std::fflush(stderr);
}

void Progress::print_line(double fraction, const std::string& stage, double seconds)
{
    const std::optional<double> left = time_left_.at(seconds, fraction);
    if (lines_.is_due(seconds, stage))
        std::fprintf(stderr, "%s: %s\n", kProgram, line_text({fraction, seconds, left, stage}).c_str());
}

void Progress::clear()
{
    if (!is_visible_)
        return;
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
    is_visible_ = false;
}

}  // namespace cleft_cli
