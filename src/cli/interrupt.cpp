#include "interrupt.hpp"

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

void on_signal(int signal)
{
    arrived = signal;
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
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    for (int signal : signals)
        sigaction(signal, &action, nullptr);
}

InterruptGuard::~InterruptGuard()
{
    for (int signal : signals)
        std::signal(signal, SIG_DFL);
    running_context = nullptr;
}

int interrupt_signal() { return arrived; }

}  // namespace cleft_cli
