// Lists that a loop makes on all threads.
#pragma once

#include "base/touched_array.hpp"

namespace cleft
{

// What body(begin, end, list) adds to the list for every chunk of `grain` items of [0, n), in the order of the chunks:
// as if one call had gone through all items.
template <class T, class Body>
Array<T> collect(const Run& run, int64_t n, int64_t grain, const Body& body)
{
    Array<Array<T>> parts(chunk_count(n, grain));
    parallel_chunks(run, n, grain, [&](int64_t chunk, int64_t begin, int64_t end) { body(begin, end, parts[chunk]); });
    Array<int64_t> first{0};  // of each part
    for (const Array<T>& part : parts)
        first.push_back(first.back() + part.count());
    Array<T> all = large_array<T>(run, first.back());
    parallel_for(run, parts.count(), 1, [&](int64_t begin, int64_t end) {
        for (int64_t p = begin; p < end; ++p) {
            std::copy(parts[p].begin(), parts[p].end(), all.begin() + first[p]);
            parts[p] = {};  // so that the list is not held twice for long
        }
    });
    return all;
}

}  // namespace cleft
