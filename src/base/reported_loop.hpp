// Loops over threads that tell how far they are.
#pragma once

#include "base/parallel.hpp"

namespace cleft
{

// As parallel_for(), and reports the part that is done. On the calling thread only.
template <class Body>
void reported_for(const Run& run, int64_t n, int64_t grain, const Body& body)
{
    parallel_chunks_by_worker(run, n, grain, [&](int worker, int64_t, int64_t begin, int64_t end) {
        if (worker == 0)  // the calling thread
            run.report(static_cast<double>(begin) / static_cast<double>(n));
        body(begin, end);
    });
}

}  // namespace cleft
