// Counts what a check finds.
#pragma once

#include <cstdint>

namespace cleft
{

// How often something was met, and where first.
struct Tally {
    int64_t count = 0;
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
