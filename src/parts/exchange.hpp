// Messages between the ranks of a run, and what happens if one of them fails.
//
// All ranks make the same calls in the same order. A rank that fails between two calls still takes part in the next
// one, with a mark in the place of its numbers: so all hear of it, and none waits for ever.
#pragma once

#include "base/array.hpp"
#include "base/error.hpp"

#include <cstdint>
#include <functional>
#include <numeric>
#include <string>
#include <type_traits>

namespace cleft
{

// How bytes go to other ranks: the functions of cleft_exchange. False: the ranks cannot reach each other.
struct Messenger {
    int32_t rank = 0, ranks = 1;
    std::string scratch;  // the folder where this rank keeps what it does not work on; empty: in memory
    std::function<bool(const int64_t* send, int64_t* receive)> numbers;
    std::function<bool(const void* send, const int64_t* send_sizes, void* receive, const int64_t* receive_sizes)> bytes;
};

// What came from all ranks: the items of rank r from start[r] to before start[r + 1].
template <class T>
struct Received {
    Array<T> items;
    Array<int64_t> start;
};

class Exchange
{
public:
    explicit Exchange(Messenger messenger);
    // Of a process that is the only rank.
    static Exchange alone();

    int32_t rank() const { return messenger_.rank; }
    int32_t ranks() const { return messenger_.ranks; }
    const std::string& scratch() const { return messenger_.scratch; }

    // Runs `body` on all ranks. If that throws on some, it throws the failure of the first of them on all.
    void together(const std::function<void()>& body);

    // Sends items to each rank: send[r] to rank r.
    template <class T>
    Received<T> all_to_all(const Array<Array<T>>& send)
    {
        CLEFT_ASSERT(send.count() == ranks());
        Array<int64_t> counts(send.size());
        Array<T> joined;
        joined.reserve(std::accumulate(send.begin(), send.end(), size_t{0},
                                       [](size_t sum, const Array<T>& list) { return sum + list.size(); }));
        for (int32_t r = 0; r < ranks(); ++r) {
            counts[r] = send[r].count();
            joined.insert(joined.end(), send[r].begin(), send[r].end());
        }
        return all_to_all(joined, counts);
    }
    // The same for items that lie one after the other: counts[0] of them go to rank 0, the next to rank 1, and so on.
    template <class T>
    Received<T> all_to_all(const Array<T>& send, const Array<int64_t>& counts)
    {
        static_assert(std::is_trivially_destructible_v<T>, "items travel as bytes");
        Received<T> out;
        out.start = starts_of(received_counts(counts));
        out.items.resize(out.start.back());
        set_sizes(counts, out.start, int64_t{sizeof(T)});
        // A rank without memory for what comes says so here, before others wait for it.
        agree();
        send_bytes(send.data(), out.items.data());
        return out;
    }

    // The items of all ranks, in the order of ranks, on each of them.
    template <class T>
    Array<T> all_gather(const Array<T>& own)
    {
        return all_to_all(Array<Array<T>>(to_size(ranks()), own)).items;
    }

    // One number of each rank.
    Array<int64_t> all_gather(int64_t own) { return received_counts(Array<int64_t>(to_size(ranks()), own)); }

private:
    struct Failure {
        int32_t status;
        char sentence[1020];
    };

    // Throws if a rank has failed.
    void agree();
    Array<int64_t> received_counts(const Array<int64_t>& counts);
    static Array<int64_t> starts_of(const Array<int64_t>& counts);
    void set_sizes(const Array<int64_t>& counts, const Array<int64_t>& start, int64_t item);
    void send_bytes(const void* send, void* receive);
    void numbers(const int64_t* send, int64_t* receive);
    void throw_first_failure(const Failure& own);

    Messenger messenger_;
    bool is_broken_ = false;      // no message gets through any more
    bool heard_failure_ = false;  // of another rank
    // Made beforehand: who tells of want of memory must not need memory.
    Array<int64_t> marks_, heard_, sizes_of_failures_;
    Array<Failure> said_, told_;
    Array<int64_t> send_sizes_, receive_sizes_;  // of the message that goes next
};

}  // namespace cleft
