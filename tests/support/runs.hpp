// Runs of a number of threads, for tests of what does not depend on it.
#pragma once

#include "base/run.hpp"

namespace cleft_test
{

inline cleft::Run with_threads(int threads)
{
    cleft::Run run;
    run.threads = threads;
    return run;
}

}  // namespace cleft_test
