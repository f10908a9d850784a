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

}  // namespace cleft
