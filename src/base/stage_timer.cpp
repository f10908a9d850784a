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
        const double cpu = process_cpu_seconds() - cpu_;
        run_.note(name_ + ".cpu_seconds", cpu);
        // Processor time: threads of others on the machine do not count. The two clocks differ a little.
        const double serial = (thread_cpu_seconds() - own_) - (loop_seconds() - loops_);
        run_.note(name_ + ".serial_seconds", std::clamp(serial, 0.0, cpu));
        run_.note(name_ + ".peak_bytes", process_peak_bytes());
    } catch (...) {
        // A figure that cannot be stored must not end the run that it describes.
    }
}

}  // namespace cleft
