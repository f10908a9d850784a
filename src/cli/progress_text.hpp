// How far a run is, in words.
#pragma once

#include <optional>
#include <string>

namespace cleft_cli
{

struct ProgressFigures {
    double fraction = 0;         // of the run, in [0, 1]
    double seconds = 0;          // since the run began
    std::optional<double> left;  // seconds
    std::string stage;
};

// "8 s", "2 min 5 s", "1 h 4 min".
std::string duration_text(double seconds);
// The same in the coarser steps that an estimate has: "25 s", "3 min", "1 h 10 min".
std::string rough_duration_text(double seconds);

// A bar, and how far it is; at most `columns` characters, of which a narrow terminal has the first.
std::string bar_text(const ProgressFigures& figures, int columns);
// For a log.
std::string line_text(const ProgressFigures& figures);

}  // namespace cleft_cli
