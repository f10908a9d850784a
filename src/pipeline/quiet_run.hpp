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

}  // namespace cleft
