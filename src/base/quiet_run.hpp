// A run for work on parts.
#pragma once

#include "base/run.hpp"

namespace cleft
{

// Figures and warnings of single parts would be taken for those of the whole.
inline Run quiet(Run run)
{
    run.metrics = nullptr;
    run.on_warning = nullptr;
    return run;
}

// Work that is a part of something whose time is counted: it can be cancelled, but moves no bar.
inline Run uncounted(Run run)
{
    run = quiet(run);
    if (run.progress)
        run.progress = [outer = run.progress](double, const char*) { return outer(0, nullptr); };
    return run;
}

}  // namespace cleft
