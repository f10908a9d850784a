// Counts what a check finds.
#pragma once

#include <cstdint>

namespace cleft
{

// How often something was met, and where first.
// Checks run in parallel, with a tally per chunk; joined in the order of chunks they give the result of one thread.
struct Tally {
    int64_t count = 0;
    // Only the first place is kept, so a mesh with a million faults takes no memory for them.
    int64_t first = -1;

    void add(int64_t where)
    {
        if (count++ == 0)
            first = where;
    }
    // What `later` met lies behind all that was met here.
    void append(const Tally& later)
    {
        if (count == 0)
            first = later.first;
        count += later.count;
    }
};

}  // namespace cleft
