// Lists that a loop makes on all threads.
#pragma once

#include "base/touched_array.hpp"

#include <functional>

namespace cleft
{

// The lists of the parts one after the other. The parts lose them. list_of(part): the list of a part, or a member.
template <class T, class Part, class ListOf>
Array<T> joined(const Run& run, Array<Part>& parts, const ListOf& list_of)
{
    Array<int64_t> first{0};  // of each part
    for (Part& part : parts)
        first.push_back(first.back() + std::invoke(list_of, part).count());
    Array<T> all = large_array<T>(run, first.back());
    parallel_for(run, parts.count(), 1, [&](int64_t begin, int64_t end) {
        for (int64_t p = begin; p < end; ++p) {
            Array<T>& list = std::invoke(list_of, parts[p]);
            std::copy(list.begin(), list.end(), all.begin() + first[p]);
            list = {};  // so that the list is not held twice for long
        }
    });
    return all;
}

// What body(begin, end, list) adds to the list for every chunk of `grain` items of [0, n), in the order of the chunks:
// as if one call had gone through all items.
template <class T, class Body>
Array<T> collect(const Run& run, int64_t n, int64_t grain, const Body& body)
{
    Array<Array<T>> parts(chunk_count(n, grain));
    parallel_chunks(run, n, grain, [&](int64_t chunk, int64_t begin, int64_t end) { body(begin, end, parts[chunk]); });
    return joined<T>(run, parts, [](Array<T>& part) -> Array<T>& { return part; });
}

}  // namespace cleft
