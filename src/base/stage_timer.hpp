// Notes NAME.seconds, NAME.cpu_seconds (all threads), NAME.serial_seconds (of the calling thread, outside of loops
// that threads can share) and NAME.peak_bytes (of the process so far) when a scope ends.
#pragma once

#include "base/process_figures.hpp"
#include "base/run.hpp"

#include <chrono>

namespace cleft
{

class StageTimer
{
public:
    StageTimer(const Run& run, std::string name)
        : run_(run),
          name_(std::move(name)),
          wall_(std::chrono::steady_clock::now()),
          cpu_(process_cpu_seconds()),
          own_(thread_cpu_seconds()),
          loops_(loop_seconds())
    {
    }
    ~StageTimer();
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

private:
    double loop_seconds() const { return run_.loop_time ? 1e-9 * static_cast<double>(run_.loop_time->load()) : 0.0; }

    // A copy: what it was made of may be gone when the scope ends.
    const Run run_;
    std::string name_;
    std::chrono::steady_clock::time_point wall_;
    double cpu_, own_, loops_;
};

}  // namespace cleft
