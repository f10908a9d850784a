// Large arrays whose memory all threads touch first. The system clears a page when it is first written to, which takes
// longer than to fill it: on one thread that was a sixth of all time outside of loops.
#pragma once

#include "base/large_pages.hpp"
#include "base/parallel.hpp"

namespace cleft
{

// Memory that is reserved and holds nothing so far.
inline void touch_pages(const Run& run, void* memory, size_t bytes)
{
    // A large page, and the least page that there is.
    constexpr int64_t kAtOnce = int64_t{2} << 20;
    constexpr int64_t kPage = 4096;
    auto* const first = static_cast<volatile char*>(memory);
    parallel_for(run, static_cast<int64_t>(bytes), kAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; i += kPage)
            first[i] = 0;
    });
}

// As large_array().
template <class T, class Integer>
Array<T> large_array(const Run& run, Integer count, const T& value = T())
{
    Array<T> array;
    reserve_large(array, count);
    touch_pages(run, array.data(), to_size(count) * sizeof(T));
    array.assign(count, value);
    return array;
}

// A copy.
template <class T>
Array<T> large_copy(const Run& run, const Array<T>& from)
{
    Array<T> copy;
    reserve_large(copy, from.size());
    touch_pages(run, copy.data(), from.size() * sizeof(T));
    copy.assign(from.begin(), from.end());
    return copy;
}

// As array_with_room().
template <class T, class Integer>
Array<T> array_with_room(const Run& run, Integer count, const T& value = T())
{
    Array<T> array;
    reserve_large(array, to_size(count) + room_beside(to_size(count)));
    touch_pages(run, array.data(), to_size(count) * sizeof(T));
    array.assign(count, value);
    return array;
}

}  // namespace cleft
