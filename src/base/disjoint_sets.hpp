// Sets of numbers that join (union-find). A set is known by its least member, so the result has one form only, also
// where several threads join.
#pragma once

#include "base/large_pages.hpp"
#include "base/shared_access.hpp"

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

    // The least member of the set. find() and join() may be called by several threads at once: whatever they do, a
    // parent is a lesser member of the same set, or the number itself. So a path leads to the root, by a detour at
    // most.
    int32_t find(int32_t i)
    {
        for (int32_t up = load_shared(parent_[i]); up != i;) {
            const int32_t above = load_shared(parent_[up]);
            if (above != up)
                store_shared(parent_[i], above);  // halves the path
            i = above;
            up = load_shared(parent_[i]);
        }
        return i;
    }

    void join(int32_t a, int32_t b)
    {
        // Not by size: the least member as root costs some longer paths, which find() halves, and makes the result
        // independent of the order of joins. Where another thread has joined that root first, its set is looked up
        // anew.
        do {
            a = find(a);
            b = find(b);
        } while (a != b && !replace_shared(parent_[std::max(a, b)], std::max(a, b), std::min(a, b)));
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
