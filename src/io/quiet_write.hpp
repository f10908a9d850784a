// Writing that ends no process: a limit on the size of files is met with an error, not with a signal.
#pragma once

#include <signal.h>

#include <cstddef>

namespace cleft::io
{

// Keeps SIGXFSZ, which by default ends the process, from this thread, and takes back the one that came meanwhile.
class SizeSignalBlocked
{
public:
    SizeSignalBlocked() noexcept;
    ~SizeSignalBlocked();
    SizeSignalBlocked(const SizeSignalBlocked&) = delete;
    SizeSignalBlocked& operator=(const SizeSignalBlocked&) = delete;

private:
    sigset_t signal_{};
    sigset_t before_{};
    bool was_pending_ = false;
};

// Writes all bytes. The answer is 0 or the error number; EFBIG where RLIMIT_FSIZE does not allow more.
int write_quietly(int descriptor, const char* bytes, size_t count) noexcept;

}  // namespace cleft::io
