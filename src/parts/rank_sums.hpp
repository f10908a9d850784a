// Sums over all ranks, the same on each of them.
#pragma once

#include "parts/exchange.hpp"

namespace cleft
{

// Of arrays that have equally many items on all ranks: item by item, in the order of ranks.
template <class T>
Array<T> sums_of_ranks(const Array<T>& own, Exchange& exchange)
{
    const Array<T> all = exchange.all_gather(own);
    Array<T> sums(own.size(), T{});
    for (size_t i = 0; i < all.size(); ++i)
        sums[i % own.size()] += all[i];
    return sums;
}

inline int64_t sum_of_ranks(int64_t own, Exchange& exchange)
{
    const Array<int64_t> all = exchange.all_gather(own);
    return std::accumulate(all.begin(), all.end(), int64_t{0});
}

}  // namespace cleft
