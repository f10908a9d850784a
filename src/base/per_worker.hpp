// What each thread of a loop has for itself.
#pragma once

#include "base/parallel.hpp"

#include <deque>

namespace cleft
{

// One T for each worker of the run's loops, made from the same arguments. What a loop makes must not depend on them.
template <class T>
class PerWorker
{
public:
    template <class... Arguments>
    explicit PerWorker(const Run& run, Arguments&&... arguments)
    {
        for (int worker = 0; worker < worker_count(run); ++worker)
            all_.emplace_back(arguments...);
    }

    T& operator[](int worker) { return all_[to_size(worker)]; }
    auto begin() { return all_.begin(); }
    auto end() { return all_.end(); }

private:
    // Threads that write to one line of the caches wait for each other.
    static constexpr std::size_t kLine = 64;
    struct alignas(kLine) Own : T {
        using T::T;
    };
    std::deque<Own> all_;  // which needs no copies or moves
};

}  // namespace cleft
