// Which points of a mesh may be moved side by side, when each move depends on those before.
#pragma once

#include "base/visit_levels.hpp"
#include "remeshing/local_mesh.hpp"

namespace cleft
{

// Visits of points number_of(0) to number_of(count - 1), in this order. A visit may move its point, and looks at the
// tetrahedra there.
template <class NumberOf>
VisitLevels levels_of_points(const LocalMesh& mesh, int64_t count, const NumberOf& number_of, const Run& run)
{
    VisitLevels levels(mesh.slot_count(), run);
    for (int64_t i = 0; i < count; ++i) {
        run.check_at(i, 1 << 12);
        levels.add(mesh.star(number_of(i)));
    }
    return levels;
}

}  // namespace cleft
