// What the process, or a thread of it, has used so far.
#pragma once

namespace cleft
{

// User and system time of all threads since the process began.
double process_cpu_seconds();
// User and system time of the calling thread.
double thread_cpu_seconds();
// The greatest memory that was resident at once. It never falls, so a later stage shows it only where it needs more.
double process_peak_bytes();

}  // namespace cleft
