// Whether a part is given by the rank that it was made for.
#pragma once

#include "parts/exchange.hpp"

namespace cleft
{

// Throws unless it is.
inline void check_ranks_of_part(int32_t rank, int32_t ranks, const Exchange& exchange)
{
    if (rank != exchange.rank() || ranks != exchange.ranks())
        throw Error(CLEFT_ERROR_ARGUMENT, "the part is that of rank " + std::to_string(rank) + " of " +
                                              std::to_string(ranks) + ", and is given by rank " +
                                              std::to_string(exchange.rank()) + " of " +
                                              std::to_string(exchange.ranks()));
}

}  // namespace cleft
