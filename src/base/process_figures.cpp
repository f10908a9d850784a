// Time as getrusage() has it, memory as the system shows it in /proc.
#include "base/process_figures.hpp"

#include <sys/resource.h>

#include <fcntl.h>
#include <unistd.h>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

namespace cleft
{

namespace
{

rusage usage_of_process()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage;
}

// The peak of this program alone; 0 where there is no /proc. By system calls, so that it works without free memory.
double peak_kilobytes_of_program()
{
    const int file = open("/proc/self/status", O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return 0;
    char text[4096];
    const ssize_t bytes = read(file, text, sizeof text - 1);
    close(file);
    if (bytes <= 0)
        return 0;
    text[bytes] = 0;
    const char* name = "\nVmHWM:";
    const char* line = std::strstr(text, name);
    return line ? static_cast<double>(std::strtoll(line + std::strlen(name), nullptr, 10)) : 0;
}

}  // namespace

double process_cpu_seconds()
{
    const rusage usage = usage_of_process();
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double thread_cpu_seconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double process_peak_bytes()
{
    // Linux counts both in KiB. What getrusage() says begins with the peak of the program that started this one, which
    // may be an interpreter with gigabytes of its own.
    const double kilobytes = peak_kilobytes_of_program();
    return 1024 * (kilobytes > 0 ? kilobytes : static_cast<double>(usage_of_process().ru_maxrss));
}

}  // namespace cleft
