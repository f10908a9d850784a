// Repair of slivers in a background mesh, where no material boundary is in the way.
#pragma once

#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

struct RepairOptions {
    double target_angle = 30;  // degrees; tetrahedra with a worse least dihedral angle are worked on
    int passes = 15;           // over what is still bad
    int sweeps = 1;            // guarded smoothing sweeps of poor parts towards centroids, before the passes
    Array<int32_t> held;       // points of the hull that stay where they are, with the triangles between them
};

// Flips and smoothing; numbers of points stay. Points on a flat part of the hull stay in it, exactly for planes across
// an axis. No operation leaves a tetrahedron worse than the worst that it replaces, but for the sweep, which may leave
// one at 22 degrees. Sequential: the same bytes for every thread count. Notes background.repair.{tets, min_angle,
// max_angle, below_10, below_15, below_20, below_25, below_30}_{before, after}.
void repair(TetMesh& mesh, const RepairOptions& options, const Run& run);

}  // namespace cleft
