// Ctrl-C (and SIGTERM, SIGHUP) become a cancel of the library's running call.
#pragma once

#include "cleft/cleft.h"

namespace cleft_cli
{

// While it lives, the first signal cancels; a second one kills the process in the usual way.
class InterruptGuard
{
public:
    explicit InterruptGuard(cleft_context* context);
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
};

// The signal that arrived, 0 if none did.
int interrupt_signal();

}  // namespace cleft_cli
