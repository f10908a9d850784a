// Standard output without a buffer of its own, so that no failure is met after the command has ended.
#include "standard_output.hpp"

#include "interrupt.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>

namespace cleft_cli
{
namespace
{

void fail_if(int error, bool is_report)
{
    if (error == 0)
        return;
    Failure failure = failure_of_write(error, "standard output cannot be written");
    // No report says that a report cannot be printed.
    failure.is_reported = !is_report;
    throw failure;
}

// So often a wait looks whether a signal has arrived: the handlers have interrupted calls go on, so that the library's
// reads and writes do.
constexpr int kMillisecondsOfWait = 50;

// False: a signal has arrived, and it is not ready.
bool wait_until_ready(int descriptor)
{
    for (;;) {
        const bool is_stopped = interrupt_signal() != 0;
        pollfd asked = {descriptor, POLLOUT, 0};
        const int found = poll(&asked, 1, is_stopped ? 0 : kMillisecondsOfWait);
        // The write that follows tells of any other error.
        if (found > 0 || (found < 0 && errno != EINTR))
            return true;
        if (is_stopped)
            return false;
    }
}

bool is_pipe(const std::string& path)
{
    struct stat status = {};
    return stat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode);
}

}  // namespace

// By write() and not printf(): a buffer that is flushed by exit() loses its error.
int write_all(int descriptor, std::string_view text)
{
    for (std::size_t written = 0; written < text.size();) {
        if (!wait_until_ready(descriptor))
            return ECANCELED;
        // A pipe that is ready takes so much at once.
        const ssize_t n =
            write(descriptor, text.data() + written, std::min<std::size_t>(text.size() - written, PIPE_BUF));
        if (n < 0 && errno != EINTR)
            return errno;
        written += n > 0 ? static_cast<std::size_t>(n) : 0;
    }
    return 0;
}

Failure failure_of_write(int error, const std::string& sentence)
{
    if (error == ECANCELED)
        return stopped_by_signal();
    return {EXIT_CANNOT_WRITE, CLEFT_ERROR_FILE, sentence + ": " + std::strerror(error)};
}

int open_for_writing(const std::string& path, bool is_new)
{
    // O_EXCL: a file that is there would be somebody else's.
    const int flags = O_WRONLY | O_CLOEXEC | (is_new ? O_CREAT | O_EXCL : 0);
    if (is_new || !is_pipe(path))
        return open(path.c_str(), flags, 0666);
    for (;;) {
        const bool is_stopped = interrupt_signal() != 0;
        const int descriptor = open(path.c_str(), flags | O_NONBLOCK);
        if (descriptor >= 0)
            (void)fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
        if (descriptor >= 0 || errno != ENXIO)
            return descriptor;
        if (is_stopped) {
            errno = ECANCELED;
            return -1;
        }
        (void)poll(nullptr, 0, kMillisecondsOfWait);
    }
}

void print_summary_text(const std::string& text)
{
    const int error = write_all(STDOUT_FILENO, text);
    // `cleft info FILE | head` is no failure.
    fail_if(error == EPIPE ? 0 : error, false);
}

void print_report(const std::string& text) { fail_if(write_all(STDOUT_FILENO, text), true); }

void make_streams_safe()
{
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
        // Some batch systems and cron jobs start programs with closed streams. A mesh that is
        // opened as descriptor 2 would get the warnings.
        if (fcntl(stream, F_GETFD) < 0)
            (void)open("/dev/null", O_RDONLY);  // takes the lowest number that is free
    // write() then fails with EFBIG or EPIPE, which has a sentence and an exit code.
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace cleft_cli
