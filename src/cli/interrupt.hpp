// Ctrl-C (and SIGTERM, SIGHUP) become a cancel of the library's running call.
#pragma once

#include "cleft/cleft.h"
#include "exit_code.hpp"

#include <csignal>

namespace cleft_cli
{

// While it lives, the first signal cancels; a second one kills the process in the usual way, but for
// what is staged, which goes.
class InterruptGuard
{
public:
    // `context` must outlive it. There may be one such object at a time, as handlers belong to the
    // process.
    explicit InterruptGuard(cleft_context* context);
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
};

// Keeps these signals from what must not be left halfway; they arrive when it ends.
class SignalsLater
{
public:
    SignalsLater() noexcept;
    ~SignalsLater();
    SignalsLater(const SignalsLater&) = delete;
    SignalsLater& operator=(const SignalsLater&) = delete;

private:
    sigset_t before_;
};

// The signal that arrived, 0 if none did.
int interrupt_signal();
// The failure of a command that it stopped.
Failure stopped_by_signal();

}  // namespace cleft_cli
