// Clocks and memory of the process, as getrusage() has them.
#include "base/stage_timer.hpp"

#include <sys/resource.h>

namespace cleft
{

double process_cpu_seconds()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double process_peak_bytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    // Linux counts in KiB.
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

StageTimer::~StageTimer()
{
    try {
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - wall_;
        run_.note(name_ + ".seconds", wall.count());
        run_.note(name_ + ".cpu_seconds", process_cpu_seconds() - cpu_);
        run_.note(name_ + ".peak_bytes", process_peak_bytes());
    } catch (...) {
        // A figure that cannot be stored must not end the run that it describes.
    }
}

}  // namespace cleft
