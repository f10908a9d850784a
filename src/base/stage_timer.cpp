// Notes the figures of a stage at its end.
#include "base/stage_timer.hpp"

#include <algorithm>

namespace cleft
{

StageTimer::~StageTimer()
{
    try {
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - wall_;
        run_.note(name_ + ".seconds", wall.count());
        run_.note(name_ + ".cpu_seconds", process_cpu_seconds() - cpu_);
        run_.note(name_ + ".serial_seconds", std::max(0.0, wall.count() - (loop_seconds() - loops_)));
        run_.note(name_ + ".peak_bytes", process_peak_bytes());
    } catch (...) {
        // A figure that cannot be stored must not end the run that it describes.
    }
}

}  // namespace cleft
