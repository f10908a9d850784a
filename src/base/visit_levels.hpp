// Visits one after the other, done side by side: the result is that of the given order, for any number of threads.
// A visit may begin as soon as all earlier ones that it shares a place with are done (Blelloch, Fineman, Shun 2012:
// greedy sequential algorithms are parallel on average).
#pragma once

#include "base/parallel.hpp"

namespace cleft
{

// Which visits may go side by side. Places are numbers, of points say.
class VisitLevels
{
public:
    VisitLevels(int64_t places, const Run& run)
        : has_one_thread_(worker_count(run) == 1), level_of_place_(has_one_thread_ ? 0 : places, 0)
    {
    }

    // The next visit in the order. Those that share a place come one after the other. `least`: the level that it has at
    // least. Returns its level. One thread keeps the order as it is, and all levels are 0.
    // Where visits change points and see the points next to these, tetrahedra are the places: those at the points that
    // a visit changes. Two points are next to each other if they are in one tetrahedron.
    template <class Places>
    int32_t add(const Places& places, int32_t least = 0)
    {
        if (has_one_thread_) {
            level_.push_back(0);
            return 0;
        }
        int32_t level = least;
        for (const int32_t place : places)
            level = std::max(level, level_of_place_[place]);
        for (const int32_t place : places)
            level_of_place_[place] = level + 1;
        level_.push_back(level);
        return level;
    }

    // do_visit(worker, i) for all i, level by level. The run has as many threads as that of the constructor.
    template <class Visit>
    void visit_all(const Run& run, const Visit& do_visit) const
    {
        CLEFT_ASSERT(has_one_thread_ == (worker_count(run) == 1));
        if (has_one_thread_) {
            const LoopTimer timer(run, level_.count());
            run.for_each(level_.count(), [&](int64_t i) { do_visit(0, static_cast<int32_t>(i)); });
            return;
        }
        const Array<Array<int32_t>> levels = by_level();
        int64_t done = 0;
        for (const Array<int32_t>& level : levels) {
            run.report(static_cast<double>(done) / static_cast<double>(level_.count()));
            parallel_chunks_by_worker(run, level.count(), kAtOnce,
                                      [&](int worker, int64_t, int64_t begin, int64_t end) {
                                          for (int64_t i = begin; i < end; ++i)
                                              do_visit(worker, level[i]);
                                      });
            done += level.count();
        }
    }

private:
    // Visits take some microseconds. More at once would leave threads without work in small levels.
    static constexpr int64_t kAtOnce = 32;

    // In each level the visits keep their order, in which neighbours mostly follow one another.
    Array<Array<int32_t>> by_level() const
    {
        Array<Array<int32_t>> levels;
        for (int64_t i = 0; i < level_.count(); ++i) {
            if (level_[i] >= levels.count())
                levels.resize(level_[i] + 1);
            levels[level_[i]].push_back(static_cast<int32_t>(i));
        }
        return levels;
    }

    const bool has_one_thread_;
    Array<int32_t> level_;           // by visit
    Array<int32_t> level_of_place_;  // above those of all visits to it so far
};

}  // namespace cleft
