// Bytes of 0 or 1 that several threads may set at once.
#pragma once

#include "base/array.hpp"

#include <atomic>

namespace cleft
{

// Threads that set the same flag must set it to the same value, or do so in an order of their own making: the flags
// themselves order nothing.
class AtomicFlags
{
public:
    AtomicFlags() = default;
    AtomicFlags(size_t count, bool value) : flags_(count)
    {
        for (auto& flag : flags_)
            flag.store(value ? 1 : 0, std::memory_order_relaxed);
    }

    template <class Integer>
    bool operator[](Integer i) const
    {
        return flags_[i].load(std::memory_order_relaxed) != 0;
    }
    template <class Integer>
    void set(Integer i, bool value)
    {
        flags_[i].store(value ? 1 : 0, std::memory_order_relaxed);
    }

    size_t size() const { return flags_.size(); }

private:
    Array<std::atomic<uint8_t>> flags_;
};

}  // namespace cleft
