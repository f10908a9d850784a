// Standard output without a buffer of its own, so that no failure is met after the command has ended.
#include "standard_output.hpp"

#include "exit_code.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
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
    Failure failure(EXIT_CANNOT_WRITE, CLEFT_ERROR_FILE,
                    std::string("standard output cannot be written: ") + std::strerror(error));
    // No report says that a report cannot be printed.
    failure.is_reported = !is_report;
    throw failure;
}

}  // namespace

// By write() and not printf(): a buffer that is flushed by exit() loses its error.
int write_all(int descriptor, const std::string& text)
{
    for (std::size_t written = 0; written < text.size();) {
        const ssize_t n = write(descriptor, text.data() + written, text.size() - written);
        if (n < 0 && errno != EINTR)
            return errno;
        written += n > 0 ? static_cast<std::size_t>(n) : 0;
    }
    return 0;
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
