// Which rank has which blocks.
#pragma once

#include "parts/exchange.hpp"

namespace cleft
{

// Blocks first .. first + count - 1 of all.
struct OwnBlocks {
    int32_t first = 0, count = 0;

    int32_t end() const { return first + count; }
};

// Each rank has blocks one after the other, those of lower ranks first. Some may have none.
class BlockShares
{
public:
    // As many for each, or one more.
    static BlockShares equal(int32_t blocks, int32_t ranks);
    // So that the rank with the most work has as little as can be. `work` has a number for each block.
    static BlockShares balanced(const Array<double>& work, int32_t ranks);

    int32_t blocks() const { return first_.back(); }
    OwnBlocks of(int32_t rank) const { return {first_[rank], first_[rank + 1] - first_[rank]}; }
    OwnBlocks own(const Exchange& exchange) const { return of(exchange.rank()); }
    int32_t owner(int32_t block) const;
    // Of the rank that has the most.
    int32_t greatest_count() const;

private:
    explicit BlockShares(Array<int32_t> first) : first_(std::move(first)) {}

    Array<int32_t> first_;  // by rank, and the number of all
};

}  // namespace cleft
