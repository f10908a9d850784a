// Sets of numbers that join (union-find). A set is known by its least member, so the result has one form only.
#pragma once

#include "base/large_pages.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace cleft
{

class DisjointSets
{
public:
    // Each of 0 .. count - 1 alone.
    explicit DisjointSets(size_t count) : parent_(large_vector<int32_t>(count))
    {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    int32_t find(int32_t i)
    {
        while (parent(i) != i) {
            parent(i) = parent(parent(i));  // halves the path
            i = parent(i);
        }
        return i;
    }

    void join(int32_t a, int32_t b)
    {
        a = find(a);
        b = find(b);
        parent(std::max(a, b)) = std::min(a, b);
    }

    // By number: the least member of its set.
    std::vector<int32_t> take()
    {
        for (int32_t& up : parent_)  // one that is less comes before
            up = parent(up);
        return std::move(parent_);
    }

private:
    int32_t& parent(int32_t i) { return parent_[static_cast<size_t>(i)]; }

    std::vector<int32_t> parent_;
};

}  // namespace cleft
