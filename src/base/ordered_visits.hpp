// Visits one after the other, done side by side: the result is that of their order, for any number of threads.
#pragma once

#include "base/per_worker.hpp"

#include <algorithm>

namespace cleft
{

// Visits 0 to count - 1. One may begin as soon as the earlier ones that it depends on are done (Blelloch, Fineman, Shun
// 2012: greedy sequential algorithms are parallel on average).
class OrderedVisits
{
public:
    // list_earlier(i, list) adds to the list the visits before i that i depends on. It is called on all threads. One
    // thread keeps the order as it is, and asks for nothing.
    template <class ListEarlier>
    OrderedVisits(int64_t count, const ListEarlier& list_earlier, const Run& run)
        : count_(count), earlier_(worker_count(run) == 1 ? 0 : chunk_count(count, kAtOnce))
    {
        if (earlier_.empty())
            return;
        parallel_chunks(run, count, kAtOnce, [&](int64_t chunk, int64_t begin, int64_t end) {
            Earlier& of_chunk = earlier_[chunk];
            of_chunk.start = {0};
            for (int64_t i = begin; i < end; ++i) {
                list_earlier(i, of_chunk.visits);
                of_chunk.start.push_back(of_chunk.visits.count());
            }
        });
    }

    // do_visit(worker, i) for all i. The run has as many threads as that of the constructor.
    template <class Visit>
    void visit_all(const Run& run, const Visit& do_visit) const
    {
        if (earlier_.empty()) {
            CLEFT_ASSERT(count_ == 0 || worker_count(run) == 1);
            const LoopTimer timer(run, count_);
            run.for_each(count_, [&](int64_t i) { do_visit(0, static_cast<int32_t>(i)); });
            return;
        }
        Progress progress(count_, run);
        try_visits(
            run, progress, count_, [](int64_t i) { return static_cast<int32_t>(i); }, do_visit);
        // Of those that are left, the first chunk can always be made.
        for (auto left = progress.take_waiting(); !left.empty(); left = progress.take_waiting())
            try_visits(
                run, progress, left.count(), [&](int64_t k) { return left[k]; }, do_visit);
    }

private:
    // Visits follow one another in space, mostly, so a thread has near ones in its chunk. Larger chunks would leave
    // threads without work in small meshes. Of smaller ones, more visits wait for those of other threads.
    static constexpr int64_t kAtOnce = 256;

    // Those that the visits of a chunk depend on: start[k] to start[k + 1] - 1 are of its visit k.
    struct Earlier {
        Array<int64_t> start;
        Array<int32_t> visits;
    };

    struct Waiting {
        Array<int32_t> visits;
    };

    // Which visits are done.
    class Progress
    {
    public:
        Progress(int64_t count, const Run& run) : done_(to_size(count)), waiting_(run)
        {
            for (auto& one : done_)
                one.store(0, std::memory_order_relaxed);
        }
        // Whoever finds a visit done also finds what it has changed.
        bool is_done(int32_t i) const { return done_[i].load(std::memory_order_acquire) != 0; }
        void note_done(int32_t i) { done_[i].store(1, std::memory_order_release); }
        // Those that a thread could not make yet, in their order.
        Array<int32_t>& waiting(int worker) { return waiting_[worker].visits; }
        // Those of all threads, in their order.
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

    private:
        Array<std::atomic<uint8_t>> done_;
        PerWorker<Waiting> waiting_;
    };

    bool may_begin(int32_t i, const Progress& progress) const
    {
        const Earlier& of_chunk = earlier_[i / kAtOnce];
        const auto* const visits = of_chunk.visits.data();
        const int64_t k = i % kAtOnce;
        return std::all_of(visits + of_chunk.start[k], visits + of_chunk.start[k + 1],
                           [&](int32_t j) { return progress.is_done(j); });
    }

    // Visits number_of(0) to number_of(count - 1), in ascending order. What has to wait for another thread is tried
    // again after the chunk, when that thread is further, mostly.
    template <class NumberOf, class Visit>
    void try_visits(const Run& run, Progress& progress, int64_t count, const NumberOf& number_of,
                    const Visit& do_visit) const
    {
        parallel_chunks_by_worker(run, count, kAtOnce, [&](int worker, int64_t, int64_t begin, int64_t end) {
            if (worker == 0)  // the calling thread
                run.report(static_cast<double>(begin) / static_cast<double>(count));
            const auto is_made = [&](int32_t i) {
                if (!may_begin(i, progress))
                    return false;
                do_visit(worker, i);
                progress.note_done(i);
                return true;
            };
            Array<int32_t>& waiting = progress.waiting(worker);
            for (int64_t k = begin; k < end; ++k)
                if (const int32_t i = number_of(k); !is_made(i))
                    waiting.push_back(i);
            waiting.erase(std::remove_if(waiting.begin(), waiting.end(), is_made), waiting.end());
        });
    }

    const int64_t count_;
    Array<Earlier> earlier_;  // by chunk; none for one thread
};

}  // namespace cleft
