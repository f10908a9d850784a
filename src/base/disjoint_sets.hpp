// Sets of numbers that join (union-find). A set is known by its least member, so the result has one form only.
#pragma once

#include "base/large_pages.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace cleft
{

class DisjointSets
{
public:
    // Each of 0 .. count - 1 alone.
    explicit DisjointSets(size_t count) : parent_(large_array<int32_t>(count))
    {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    // The least member of the set.
    int32_t find(int32_t i)
    {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];  // halves the path
            i = parent_[i];
        }
        return i;
    }

    void join(int32_t a, int32_t b)
    {
        a = find(a);
        b = find(b);
        // Not by size: the least member as root costs some longer paths, which find() halves, and makes the result
        // independent of the order of joins.
        parent_[std::max(a, b)] = std::min(a, b);
    }

    // By number: the least member of its set.
    Array<int32_t> take()
    {
        for (int32_t i = 0; i < parent_.count(); ++i) {
            CLEFT_ASSERT(parent_[i] <= i);
            parent_[i] = parent_[parent_[i]];  // one that is less comes before
        }
        return std::move(parent_);
    }

private:
    Array<int32_t> parent_;
};

}  // namespace cleft
