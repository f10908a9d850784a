// CLEFT_ASSERT(condition) states an invariant of the code. Builds with the CMake option CLEFT_ASSERTIONS check it, and
// end the process where it does not hold, for that is a defect of ours. Other builds do not evaluate the condition.
// What a user brings is never asserted (decision 15).
#pragma once

#ifdef CLEFT_ASSERTIONS

#include <cstdio>
#include <cstdlib>

namespace cleft
{

[[noreturn]] inline void fail_assertion(const char* condition, const char* file, int line)
{
    std::fprintf(stderr, "%s:%d: assertion failed: %s\n", file, line, condition);
    std::abort();
}

}  // namespace cleft

#define CLEFT_ASSERT(condition) \
    static_cast<void>((condition) || (cleft::fail_assertion(#condition, __FILE__, __LINE__), false))

#else

// The condition is compiled, so that it stays valid code and its variables count as used, but never runs.
#define CLEFT_ASSERT(condition) static_cast<void>(true || (condition))

#endif
