// Turns signals into a cancel of the library's call, and removes unfinished files where a signal
// ends the command at once.
#include "interrupt.hpp"

#include "staged_outputs.hpp"

#include <atomic>
#include <csignal>

namespace cleft_cli
{
namespace
{

// Those by which a terminal, a user or a batch system ends a program. SIGQUIT is left to leave a
// core file.
constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

// A signal handler has no argument of its own: these two are the only globals of the command.
std::atomic<cleft_context*> running_context{nullptr};
// The only type besides lock-free atomics that a handler may write (C11, section 7.14.1.1).
volatile std::sig_atomic_t arrived = 0;
static_assert(std::atomic<cleft_context*>::is_always_lock_free, "a signal handler may read lock-free atomics only");

// The second signal, or one between calls of the library: what is staged goes, and the signal does what it does by
// default.
void on_idle_signal(int signal)
{
    // Only functions that a handler may call are called here; see remove_all().
    StagedOutputs::remove_all();
    // raise() then ends the command by the signal itself, which shells and batch systems look for.
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

void on_signal(int signal)
{
    arrived = signal;
    // A call that takes long to cancel can be ended by a second Ctrl-C.
    std::signal(signal, on_idle_signal);
    // With a sound handle, this only stores to an atomic flag, so it may be called here.
    if (cleft_context* context = running_context.load())
        cleft_context_cancel(context);
}

// Whoever started the command may want it to go on, as nohup does.
bool is_ignored(int signal)
{
    struct sigaction now = {};
    return sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

InterruptGuard::InterruptGuard(cleft_context* context)
{
    running_context = context;
    struct sigaction action = {};
    action.sa_handler = on_signal;
    // Reads and writes go on after the handler. The cancel reaches the library by its flag.
    action.sa_flags = SA_RESTART;
    for (int signal : kSignals)
        if (!is_ignored(signal))
            sigaction(signal, &action, nullptr);
}

InterruptGuard::~InterruptGuard()
{
    for (int signal : kSignals)
        if (!is_ignored(signal))
            std::signal(signal, on_idle_signal);
    // After the handlers are replaced: the other way round, a signal in between would cancel
    // nothing.
    running_context = nullptr;
}

// Blocked and not ignored: the signal stays pending and arrives when the destructor unblocks it.
SignalsLater::SignalsLater() noexcept
{
    sigset_t blocked;
    sigemptyset(&blocked);
    for (const int signal : kSignals)
        sigaddset(&blocked, signal);
    pthread_sigmask(SIG_BLOCK, &blocked, &before_);
}

SignalsLater::~SignalsLater() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

int interrupt_signal() { return arrived; }

Failure stopped_by_signal()
{
    // The convention of shells for a program that was ended by a signal.
    return {128 + interrupt_signal(), CLEFT_ERROR_CANCELLED, "stopped by a signal; nothing was written"};
}

}  // namespace cleft_cli
