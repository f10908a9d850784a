// A counting sort on all threads: values that items give to keys, grouped by key.
#pragma once

#include "base/touched_array.hpp"

#include <algorithm>

namespace cleft
{

// The values of key k are values[start[k]] to values[start[k + 1] - 1], in the order in which the items give them.
template <class Number, class Value>
struct Groups {
    Array<Number> start;  // one more than keys
    Array<Value> values;
};

// All tables together have at most two entries an item, about half of what they help to sort in a mesh.
inline int64_t most_parts(int64_t items, int64_t keys) { return 1 + 2 * items / std::max<int64_t>(1, keys); }

// How many items a thread takes where each part of a loop needs a table of all keys. This cut depends on the number of
// threads: only for loops whose result is the same for every cut.
inline int64_t items_of_part(const Run& run, int64_t items, int64_t keys)
{
    const int64_t parts = std::min<int64_t>(std::max(1, run.threads), most_parts(items, keys));
    return std::max<int64_t>(1, (items + parts - 1) / parts);
}

template <class Number, class Value>
class CountingSort
{
public:
    // visit(item, give) calls give(key, value), the same each time. `Number` counts all values.
    template <class Visit>
    Groups<Number, Value> sort(const Run& run, int64_t items, int64_t keys, const Visit& visit)
    {
        const int64_t grain = items_of_part(run, items, keys);
        places_.resize(std::max<int64_t>(1, chunk_count(items, grain)));
        places_[places_.size() - 1].resize(keys + 1);
        for_parts(run, items, keys, grain, [&](int64_t part, int64_t begin, int64_t end) {
            Array<Number>& counts = places_[part];
            counts.resize(keys + 1);
            for_items(run, begin, end, visit, [&](int64_t key, const Value&) { ++counts[key + 1]; });
        });
        Array<Value> values = array_with_room<Value>(run, find_places(run, keys));
        for_parts(run, items, keys, grain, [&](int64_t part, int64_t begin, int64_t end) {
            Array<Number>& places = places_[part];
            for_items(run, begin, end, visit,
                      [&](int64_t key, const Value& value) { values[places[key + 1]++] = value; });
        });
        // The place behind the last value of a key is where the next key begins.
        return {std::move(places_[places_.size() - 1]), std::move(values)};
    }

private:
    template <class Body>
    static void for_parts(const Run& run, int64_t items, int64_t keys, int64_t grain, const Body& body)
    {
        // One thread has one part, which more threads would share.
        const LoopTimer timer(run, grain < items ? 1 : most_parts(items, keys));
        parallel_chunks(run, items, grain, body);
    }

    template <class Visit, class Give>
    static void for_items(const Run& run, int64_t begin, int64_t end, const Visit& visit, const Give& give)
    {
        for (int64_t item = begin; item < end; ++item) {
            run.check_at(item);
            visit(item, give);
        }
    }

    // Counts become places: keys in order, and the parts of a key in order. So the result is that of one part. Returns
    // the number of values.
    Number find_places(const Run& run, int64_t keys)
    {
        constexpr int64_t kKeysAtOnce = 1 << 14;  // the number changes the time alone
        Array<Number> begin_of(chunk_count(keys, kKeysAtOnce), Number{0});
        parallel_chunks(run, keys, kKeysAtOnce, [&](int64_t chunk, int64_t begin, int64_t end) {
            for (const Array<Number>& counts : places_)
                for (int64_t key = begin; key < end; ++key)
                    begin_of[chunk] += counts[key + 1];
        });
        Number all = 0;
        for (Number& begin : begin_of)
            all += std::exchange(begin, all);
        parallel_chunks(run, keys, kKeysAtOnce, [&](int64_t chunk, int64_t begin, int64_t end) {
            Number next = begin_of[chunk];
            for (int64_t key = begin; key < end; ++key)
                for (Array<Number>& counts : places_)
                    next += std::exchange(counts[key + 1], next);
        });
        return all;
    }

    // By part: of each key how many values it gives, later the place of the next one. The entry of a key is one
    // farther, so that the last part's becomes Groups::start.
    Array<Array<Number>> places_;
};

// See CountingSort::sort.
template <class Number, class Value, class Visit>
Groups<Number, Value> group_by_key(const Run& run, int64_t items, int64_t keys, const Visit& visit)
{
    return CountingSort<Number, Value>().sort(run, items, keys, visit);
}

}  // namespace cleft
