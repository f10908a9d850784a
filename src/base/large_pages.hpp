// Arrays in large pages of memory. Stages read a mesh here and there, a hundred megabytes at random: in pages of 4 KiB
// the processor spends much of that time finding the page.
#pragma once

#include "base/array.hpp"

#include <cstddef>

namespace cleft
{

// Lets the system put this memory, not written to so far, in large pages. A hint: nothing happens where there are none.
void allow_large_pages(void* data, size_t bytes);

// reserve() of an empty vector.
template <class T, class Integer>
void reserve_large(std::vector<T>& array, Integer count)
{
    array.reserve(to_size(count));
    allow_large_pages(array.data(), to_size(count) * sizeof(T));
}

// The hint comes between taking the memory and writing to it: pages that are in use already stay as they are.
template <class T, class Integer>
Array<T> large_array(Integer count, const T& value = T())
{
    Array<T> array;
    reserve_large(array, count);
    array.assign(count, value);
    return array;
}

// How many more items of so many local operations are expected to add. Memory that is reserved and not used costs
// nothing.
inline size_t room_beside(size_t count) { return count / 8; }

// Makes room for `more` items at the end. A vector would double, and not stay in large pages: of a mesh that local
// operations change a little, half of the memory would be for nothing.
template <class T>
void make_room(Array<T>& array, size_t more = 1)
{
    const size_t wanted = array.size() + more;
    if (wanted <= array.capacity())
        return;
    Array<T> larger;
    reserve_large(larger, wanted + room_beside(wanted));
    larger.assign(array.begin(), array.end());
    array.swap(larger);
}

// large_array() of so many, which may grow by some in its place.
template <class T, class Integer>
Array<T> array_with_room(Integer count, const T& value = T())
{
    Array<T> array;
    reserve_large(array, to_size(count) + room_beside(to_size(count)));
    array.assign(count, value);
    return array;
}

}  // namespace cleft
