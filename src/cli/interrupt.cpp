#include "interrupt.hpp"

#include "staged_outputs.hpp"

#include <atomic>
#include <csignal>

namespace cleft_cli
{
namespace
{

const int signals[] = {SIGINT, SIGTERM, SIGHUP};

// A signal handler has no argument of its own: these two are the only globals of the command.
std::atomic<cleft_context*> running_context{nullptr};
volatile std::sig_atomic_t arrived = 0;
static_assert(std::atomic<cleft_context*>::is_always_lock_free, "a signal handler may read lock-free atomics only");

// The second signal, or one between calls of the library: what is staged goes, and the signal does what it does by
// default.
void on_idle_signal(int signal)
{
    StagedOutputs::remove_all();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

void on_signal(int signal)
{
    arrived = signal;
    std::signal(signal, on_idle_signal);
    // With a sound handle, this only stores to an atomic flag, so it may be called here.
    if (cleft_context* context = running_context.load())
        cleft_context_cancel(context);
}

}  // namespace

InterruptGuard::InterruptGuard(cleft_context* context)
{
    running_context = context;
    struct sigaction action = {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    for (int signal : signals)
        sigaction(signal, &action, nullptr);
}

InterruptGuard::~InterruptGuard()
{
    for (int signal : signals)
        std::signal(signal, on_idle_signal);
    running_context = nullptr;
}

SignalsLater::SignalsLater() noexcept
{
    sigset_t blocked;
    sigemptyset(&blocked);
    for (const int signal : signals)
        sigaddset(&blocked, signal);
    pthread_sigmask(SIG_BLOCK, &blocked, &before_);
}

SignalsLater::~SignalsLater() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

int interrupt_signal() { return arrived; }

}  // namespace cleft_cli
