// Which visits of points of a mesh may begin.
#pragma once

#include "base/ordered_visits.hpp"
#include "base/shared_access.hpp"
#include "base/touched_array.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// For visit_in_order(): visits of points number_of(0) to number_of(count - 1), each of them once. A visit may change
// its point, and what is kept at the edges and tetrahedra there. It sees the corners of these tetrahedra.
class PendingVisits
{
public:
    template <class NumberOf>
    PendingVisits(const Run& run, int64_t points, int64_t count, const NumberOf& number_of)
    {
        if (worker_count(run) == 1)  // which does not ask
            return;
        visit_of_ = large_array(run, points, kNone);
        parallel_for(run, count, kAtOnce, [&](int64_t begin, int64_t end) {
            for (int64_t i = begin; i < end; ++i)
                visit_of_[number_of(i)] = static_cast<int32_t>(i);
        });
    }

    // Whether all visits before i of the corners of the tetrahedra at its point are done.
    template <class Tets, class TetOf>
    bool may_begin(int64_t i, const Tets& tets, const TetOf& tet_of) const
    {
        for (const int32_t t : tets)
            for (const int32_t v : tet_of(t))
                if (load_acquired(visit_of_[v]) < i)
                    return false;
        return true;
    }
    bool is_done(int32_t point) const { return load_acquired(visit_of_[point]) == kNone; }
    // The last thing in a visit.
    void note_done(int32_t point)
    {
        if (!visit_of_.empty())
            store_released(visit_of_[point], kNone);
    }

private:
    static constexpr int32_t kNone = INT32_MAX;
    // Visits that a thread takes. The number changes the time alone.
    static constexpr int64_t kAtOnce = 1 << 14;

    Array<int32_t> visit_of_;  // by point: its visit, until that is done
};

}  // namespace cleft
