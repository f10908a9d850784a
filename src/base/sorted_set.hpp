// The different values that items of a loop give, sorted, by several threads.
#pragma once

#include "base/array.hpp"
#include "base/parallel.hpp"

#include <algorithm>

namespace cleft
{

// list(begin, end, values) appends the values of the items of a chunk of [0, n). Most of them should come several times
// within a chunk: each chunk is reduced to its different values before chunks are joined.
template <class T, class List>
Array<T> sorted_set(const Run& run, int64_t n, int64_t grain, const List& list)
{
    Array<Array<T>> sets(chunk_count(n, grain));
    parallel_chunks(run, n, grain, [&](int64_t chunk, int64_t begin, int64_t end) {
        Array<T> values;
        list(begin, end, values);
        std::sort(values.begin(), values.end());
        const auto last = std::unique(values.begin(), values.end());
        sets[chunk] = Array<T>(values.begin(), last);
    });
    while (sets.count() > 1) {
        const int64_t pairs = sets.count() / 2;
        Array<Array<T>> joined(sets.count() - pairs);
        parallel_for(run, joined.count(), 1, [&](int64_t begin, int64_t end) {
            for (int64_t i = begin; i < end; ++i) {
                if (i >= pairs) {
                    joined[i] = std::move(sets[2 * i]);
                    continue;
                }
                Array<T>&a = sets[2 * i], &b = sets[2 * i + 1];
                joined[i].reserve(a.size() + b.size());
                std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(joined[i]));
                a = Array<T>();
                b = Array<T>();
            }
        });
        sets = std::move(joined);
    }
    return sets.empty() ? Array<T>() : std::move(sets[0]);
}

}  // namespace cleft
