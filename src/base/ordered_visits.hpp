// Visits one after the other, done side by side: the result is that of their order, for any number of threads.
#pragma once

#include "base/per_worker.hpp"

#include <algorithm>

namespace cleft
{

// Some visits of a list, made by all threads as far as they may begin.
template <class MayBegin, class Visit>
class OrderedVisits
{
public:
    OrderedVisits(const Run& run, const MayBegin& may_begin, const Visit& do_visit)
        : run_(run), may_begin_(may_begin), do_visit_(do_visit), waiting_(run)
    {
    }

    // Visits number_of(0) to number_of(count - 1), in ascending order. Returns those that are left, in ascending order.
    // What has to wait for another thread is tried again after the chunk, when that thread is further, mostly.
    template <class NumberOf>
    Array<int32_t> make(int64_t count, const NumberOf& number_of)
    {
        parallel_chunks_by_worker(run_, count, kAtOnce, [&](int worker, int64_t, int64_t begin, int64_t end) {
            if (worker == 0)  // the calling thread
                run_.report(static_cast<double>(begin) / static_cast<double>(count));
            const auto is_made = [&](int32_t i) {
                const bool begins = may_begin_(i);
                if (begins)
                    do_visit_(worker, i);
                return begins;
            };
            Array<int32_t>& waiting = waiting_[worker].visits;
            for (int64_t k = begin; k < end; ++k)
                if (const int32_t i = number_of(k); !is_made(i))
                    waiting.push_back(i);
            waiting.erase(std::remove_if(waiting.begin(), waiting.end(), is_made), waiting.end());
        });
        return take_waiting();
    }

private:
    // Visits follow one another in space, mostly, so a thread has near ones in its chunk. Larger chunks would leave
    // threads without work in small meshes. Of smaller ones, more visits wait for those of other threads.
    static constexpr int64_t kAtOnce = 256;

    // Those that a thread could not make yet, in their order.
    struct Waiting {
        Array<int32_t> visits;
    };

    Array<int32_t> take_waiting()
    {
        Array<int32_t> all;
        for (Waiting& one : waiting_) {
            all.insert(all.end(), one.visits.begin(), one.visits.end());
            one.visits.clear();
        }
        std::sort(all.begin(), all.end());
        return all;
    }

    const Run& run_;
    const MayBegin& may_begin_;
    const Visit& do_visit_;
    PerWorker<Waiting> waiting_;
};

// do_visit(worker, i) for i from 0 to count - 1. One may begin as soon as the earlier ones that it depends on are done
// (Blelloch, Fineman, Shun 2012: greedy sequential algorithms are parallel on average): may_begin(i) says so. It is
// called on all threads, and has to see all that a visit has changed which it finds done. One thread keeps the order as
// it is, and does not ask.
template <class MayBegin, class Visit>
void visit_in_order(const Run& run, int64_t count, const MayBegin& may_begin, const Visit& do_visit)
{
    if (worker_count(run) == 1) {
        const LoopTimer timer(run, count);
        run.for_each(count, [&](int64_t i) { do_visit(0, static_cast<int32_t>(i)); });
        return;
    }
    OrderedVisits visits(run, may_begin, do_visit);
    Array<int32_t> left = visits.make(count, [](int64_t k) { return static_cast<int32_t>(k); });
    // Each time, the first chunk at least can be made.
    while (!left.empty()) {
        const Array<int32_t> now = std::exchange(left, {});
        left = visits.make(now.count(), [&](int64_t k) { return now[k]; });
    }
}

}  // namespace cleft
