// Which points of a mesh may be moved side by side, when each move depends on those before.
#pragma once

#include "mesh/visit_numbers.hpp"
#include "remeshing/local_mesh.hpp"

namespace cleft
{

// Visits of points number_of(0) to number_of(count - 1), each of them once, in this order. A visit may move its point,
// and looks at the tetrahedra there.
template <class NumberOf>
OrderedVisits ordered_points(const LocalMesh& mesh, int64_t count, const NumberOf& number_of, const Run& run)
{
    const VisitNumbers numbers(run, mesh.point_count(), count, number_of);
    const auto tet_of = [&](int32_t t) -> const Tet& { return mesh.tet(t); };
    return {
        count,
        [&](int64_t i, Array<int32_t>& earlier) { numbers.add_earlier(i, mesh.star(number_of(i)), tet_of, earlier); },
        run};
}

}  // namespace cleft
