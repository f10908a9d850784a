// More items than there is memory for, in order: a merge sort over runs that are kept on disk.
#pragma once

#include "parts/kept_bytes.hpp"

#include <algorithm>
#include <queue>

namespace cleft
{

// Items have an operator <, and no memory of their own.
template <class T>
class SortedRuns
{
public:
    // `scratch`: the folder where they are kept; empty: they are in memory.
    explicit SortedRuns(const std::string& scratch) : kept_(scratch) {}

    void add(Array<T> items)
    {
        if (items.empty())
            return;
        std::sort(items.begin(), items.end());
        kept_.put(sizes_.count(), items);
        sizes_.push_back(items.count());
    }

    // visit(item) for all in ascending order, equal ones once.
    template <class Visit>
    void visit_all(const Visit& visit) const
    {
        Array<Reader> readers;
        std::priority_queue<Front> fronts;
        for (int64_t run = 0; run < sizes_.count(); ++run) {
            readers.push_back(Reader{run, sizes_[run], 0, 0, {}});
            fronts.push({readers.back().next(kept_), run});
        }
        const T* last = nullptr;
        T visited{};
        while (!fronts.empty()) {
            const Front front = fronts.top();
            fronts.pop();
            if (!last || *last < front.item) {
                visited = front.item;
                last = &visited;
                visit(visited);
            }
            if (readers[front.run].has_next())
                fronts.push({readers[front.run].next(kept_), front.run});
        }
    }

private:
    // Of a run in memory at a time: some tens of kilobytes. The number changes the time alone.
    static constexpr int64_t kItemsAtOnce = 2048;

    struct Reader {
        int64_t run, size, taken, at;
        Array<T> items;  // those from `at` on come next

        bool has_next() const { return taken < size || at < items.count(); }
        T next(const KeptBytes& kept)
        {
            if (at == items.count()) {
                items.clear();
                at = 0;
                const int64_t count = std::min(kItemsAtOnce, size - taken);
                kept.append(run, taken, count, items);
                taken += count;
            }
            return items[at++];
        }
    };

    struct Front {
        T item;
        int64_t run;
        // A queue has the greatest on top.
        bool operator<(const Front& o) const { return o.item < item; }
    };

    KeptBytes kept_;
    Array<int64_t> sizes_;  // of runs
};

}  // namespace cleft
