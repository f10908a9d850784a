// Visits of points of a mesh that keeps its connections, when each depends on those before.
#pragma once

#include "mesh/pending_visits.hpp"
#include "remeshing/local_mesh.hpp"

namespace cleft
{

// do_visit(worker, i) for points number_of(0) to number_of(count - 1), each of them once, in this order. A visit may
// move its point, and looks at the tetrahedra there.
template <class NumberOf, class Visit>
void visit_points_in_order(const LocalMesh& mesh, int64_t count, const NumberOf& number_of, const Run& run,
                           const Visit& do_visit)
{
    PendingVisits pending(run, mesh.point_count(), count, number_of);
    const auto tet_of = [&](int32_t t) -> const Tet& { return mesh.tet(t); };
    visit_in_order(
        run, count, [&](int32_t i) { return pending.may_begin(i, mesh.star(number_of(i)), tet_of); },
        [&](int worker, int32_t i) {
            do_visit(worker, i);
            pending.note_done(number_of(i));
        });
}

}  // namespace cleft
