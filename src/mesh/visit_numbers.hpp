// Which visits of points depend on which.
#pragma once

#include "base/ordered_visits.hpp"
#include "base/touched_array.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// Visits of points number_of(0) to number_of(count - 1), each of them once. A visit may change its point, and what is
// kept at the edges and tetrahedra there. It sees the corners of these tetrahedra.
class VisitNumbers
{
public:
    template <class NumberOf>
    VisitNumbers(const Run& run, int64_t points, int64_t count, const NumberOf& number_of)
    {
        if (worker_count(run) == 1)  // see OrderedVisits
            return;
        visit_of_ = large_array(run, points, INT32_MAX);
        parallel_for(run, count, kAtOnce, [&](int64_t begin, int64_t end) {
            for (int64_t i = begin; i < end; ++i)
                visit_of_[number_of(i)] = static_cast<int32_t>(i);
        });
    }

    // Adds those before visit i of the corners of the tetrahedra at its point, each once.
    template <class Tets, class TetOf>
    void add_earlier(int64_t i, const Tets& tets, const TetOf& tet_of, Array<int32_t>& earlier) const
    {
        const int64_t first = earlier.count();
        for (const int32_t t : tets)
            for (const int32_t v : tet_of(t)) {
                const int32_t j = visit_of_[v];
                if (j < i && std::find(earlier.begin() + first, earlier.end(), j) == earlier.end())
                    earlier.push_back(j);
            }
    }

private:
    // Visits that a thread takes. The number changes the time alone.
    static constexpr int64_t kAtOnce = 1 << 14;

    Array<int32_t> visit_of_;  // by point
};

}  // namespace cleft
