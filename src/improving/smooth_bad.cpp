// Visits bad tetrahedra side by side where they are far enough from one another.
#include "improving/smooth_bad.hpp"

#include "base/visit_levels.hpp"

#include <deque>

namespace cleft
{

namespace
{

// Moving a corner changes the tetrahedra at it, which is all that the smoothing of a point next to it looks at.
VisitLevels levels_of(const LocalMesh& mesh, const WorstFirst& bad, const Run& run)
{
    VisitLevels levels(mesh.slot_count(), run);
    Array<int32_t> around;
    for (size_t i = 0; i < bad.size(); ++i) {
        run.check_at(i, 1 << 12);
        around.clear();
        for (const int32_t v : mesh.tet(bad[i]))
            around.insert(around.end(), mesh.star(v).begin(), mesh.star(v).end());
        levels.add(around);
    }
    return levels;
}

}  // namespace

Array<MovedCorners> smooth_bad(const CornerSmoothing& smoothing, const WorstFirst& bad, const Run& run)
{
    LocalMesh& mesh = smoothing.mesh;
    std::deque<ConstrainedSmoother> smoothers;  // one for each thread
    for (int worker = 0; worker < worker_count(run); ++worker) {
        smoothers.emplace_back(mesh, smoothing.volume, smoothing.home);
        smoothers.back().aim_at(smoothing.target, smoothing.tolerance);
    }
    Array<MovedCorners> moved(bad.size(), 0);
    levels_of(mesh, bad, run).visit_all(run, [&](int worker, int32_t i) {
        const int32_t t = bad[to_size(i)];
        const Tet& corners = mesh.tet(t);
        for (size_t corner = 0; corner < 4; ++corner)
            if (mesh.quality(t) < smoothing.target && smoothers[to_size(worker)].smooth(corners[corner], false))
                moved[i] = static_cast<MovedCorners>(moved[i] | 1u << corner);
    });
    return moved;
}

}  // namespace cleft
