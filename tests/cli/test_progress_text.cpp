// What the command says of its progress, at times that the test chooses.
#include "cli/line_times.hpp"
#include "cli/progress_plan.hpp"
#include "cli/progress_text.hpp"
#include "cli/time_left.hpp"

#include <csetjmp>
#include <cstdarg>
#include <cstddef>
#include <cstdint>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

extern "C" {
#include <cmocka.h>
}

using namespace cleft_cli;

namespace
{

void assert_text(const std::string& text, const char* wanted) { assert_string_equal(text.c_str(), wanted); }

void durations(void**)
{
    assert_text(duration_text(0.99), "0 s");
    assert_text(duration_text(59.9), "59 s");
    assert_text(duration_text(125), "2 min 5 s");
    assert_text(duration_text(3599), "59 min 59 s");
    assert_text(duration_text(3840), "1 h 4 min");
    assert_text(rough_duration_text(0.2), "0 s");
    assert_text(rough_duration_text(8.4), "8 s");
    assert_text(rough_duration_text(33), "35 s");
    assert_text(rough_duration_text(57.4), "55 s");
    assert_text(rough_duration_text(57.6), "1 min");
    assert_text(rough_duration_text(3569), "59 min");
    assert_text(rough_duration_text(3571), "1 h 0 min");
    assert_text(rough_duration_text(3 * 3600 + 500), "3 h 10 min");
}

void bars(void**)
{
    ProgressFigures figures{0.5, 12, std::nullopt, "cleaving: cuts"};
    assert_text(bar_text(figures, 80), "[##########..........]  50 %  12 s  cleaving: cuts");
    figures.left = 33;
    assert_text(bar_text(figures, 80), "[##########..........]  50 %  12 s, 35 s left  cleaving: cuts");
    figures.fraction = 0.999;
    assert_text(bar_text(figures, 55), "[#########.]  99 %  12 s, 35 s left  cleaving: cuts");
    figures.fraction = 1;
    assert_text(bar_text(figures, 45), "100 %  12 s, 35 s left  cleaving: cuts");
    assert_text(line_text(figures), "100 % after 12 s, 35 s left: cleaving: cuts");
    figures.left = 0.5;
    assert_text(line_text(figures), "100 % after 12 s, 1 s left: cleaving: cuts");
    figures.left = 0.4;
    assert_text(line_text(figures), "100 % after 12 s: cleaving: cuts");
    assert_text(bar_text(figures, 45), "100 %  12 s  cleaving: cuts");
}

// However narrow the terminal and long the texts, a line is not wrapped.
void bars_fit(void**)
{
    const ProgressFigures figures{0.3, 1e5, 1e6, std::string(100, 'x')};
    for (int columns = -1; columns < 300; ++columns)
        assert_true(bar_text(figures, columns).size() <= static_cast<std::size_t>(std::max(columns, 0)));
}

void time_left_of_steady_work(void**)
{
    TimeLeft left;
    for (int i = 0; i <= 600; ++i) {
        const double seconds = i / 10.0;
        const std::optional<double> now = left.at(seconds, seconds / 60);
        assert_int_equal(now.has_value(), seconds >= 1);
        if (now)
            assert_true(std::abs(*now - (60 - seconds)) < 1e-9);
    }
}

// A call that stands still, or jumps, moves the estimate by little at once.
void time_left_is_steady(void**)
{
    TimeLeft left;
    left.at(10, 0.5);
    for (int i = 1; i <= 10; ++i)
        assert_true(std::abs(*left.at(10 + 0.1 * i, 0.5) - 10) < 1);
    TimeLeft jumping;
    jumping.at(10, 0.25);
    const double after = *jumping.at(10.1, 0.5);
    assert_true(after > 25 && after < 30);
    for (int i = 2; i < 1000; ++i)
        assert_true(*jumping.at(10 + 0.1 * i, 0.99) >= 0);
}

void no_time_left_without_progress(void**)
{
    TimeLeft left;
    assert_false(left.at(100, 0).has_value());
    assert_false(left.at(101, 0.009).has_value());
    assert_true(left.at(102, 0.02).has_value());
}

std::vector<double> times_of_lines(LineTimes lines, double end, double stage_seconds)
{
    std::vector<double> times;
    for (int i = 0; i < 10 * end; ++i)
        if (lines.is_due(0.1 * i, std::to_string(std::floor(0.1 * i / stage_seconds))))
            times.push_back(0.1 * i);
    return times;
}

void lines_of_stages(void**)
{
    // Each stage has its line, and a long one more.
    assert_int_equal(times_of_lines(LineTimes(0), 9, 3).size(), 3);
    assert_int_equal(times_of_lines(LineTimes(0), 60, 30).size(), 6);
    // Nothing in the first seconds, then the stage that runs.
    assert_true(times_of_lines(LineTimes(10), 9.5, 3).empty());
    assert_true(std::abs(times_of_lines(LineTimes(10), 12, 3).front() - 10) < 0.05);
    // Stages that come by turns do not fill the log, and an hour has a page.
    assert_true(times_of_lines(LineTimes(0), 60, 0.1).size() <= 60);
    const std::vector<double> hour = times_of_lines(LineTimes(10), 3600, 1e9);
    assert_in_range(hour.size(), 60, 100);
    for (std::size_t i = 1; i < hour.size(); ++i)
        assert_true(hour[i] - hour[i - 1] > 9.9 && hour[i] - hour[i - 1] < 60.2);
}

void plan(void**)
{
    ProgressPlan plan({{"read", 1}, {"mesh", 8}, {"write", 1}});
    assert_true(plan.at(0.5) == 0);
    plan.begin("read");
    assert_true(std::abs(plan.at(0.5) - 0.05) < 1e-12);
    plan.begin("mesh");
    assert_true(std::abs(plan.at(0) - 0.1) < 1e-12);
    assert_true(std::abs(plan.at(0.5) - 0.5) < 1e-12);
    // A second call in a part, and a part that is not in the plan.
    assert_true(std::abs(plan.at(0) - 0.5) < 1e-12);
    plan.begin("more");
    assert_true(std::abs(plan.at(1) - 0.5) < 1e-12);
    plan.begin("write");
    assert_true(std::abs(plan.at(2) - 1) < 1e-12);
    ProgressPlan empty({});
    empty.begin("read");
    assert_true(empty.at(1) == 0);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(durations),
        cmocka_unit_test(bars),
        cmocka_unit_test(bars_fit),
        cmocka_unit_test(time_left_of_steady_work),
        cmocka_unit_test(time_left_is_steady),
        cmocka_unit_test(no_time_left_without_progress),
        cmocka_unit_test(lines_of_stages),
        cmocka_unit_test(plan),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
