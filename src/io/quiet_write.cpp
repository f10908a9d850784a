// Writing that ends no process.
#include "io/quiet_write.hpp"

#include <pthread.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>

namespace cleft::io
{

SizeSignalBlocked::SizeSignalBlocked() noexcept
{
    // The mask of the calling thread alone is changed. A handler for the signal would be the
    // process's, which belongs to the caller.
    sigemptyset(&signal_);
    sigaddset(&signal_, SIGXFSZ);
    sigset_t pending;
    // A signal that was pending before is the caller's and must stay pending.
    was_pending_ = sigpending(&pending) == 0 && sigismember(&pending, SIGXFSZ) == 1;
    pthread_sigmask(SIG_BLOCK, &signal_, &before_);
}

SizeSignalBlocked::~SizeSignalBlocked()
{
    const timespec at_once{};
    // The kernel sends SIGXFSZ to the thread that writes. It is taken here with no wait, before
    // the old mask lets it through.
    while (!was_pending_ && sigtimedwait(&signal_, nullptr, &at_once) < 0 && errno == EINTR) {
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

int write_quietly(int descriptor, const char* bytes, size_t count) noexcept
{
    const SizeSignalBlocked blocked;
    for (size_t written = 0; written < count;) {
        const ssize_t n = ::write(descriptor, bytes + written, count - written);
        // write() fails with EFBIG where the signal is blocked.
        if (n < 0 && errno != EINTR)
            return errno;
        written += n > 0 ? static_cast<size_t>(n) : 0;
    }
    return 0;
}

}  // namespace cleft::io
