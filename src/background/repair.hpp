// Repair of slivers in a background mesh, where no material boundary is in the way.
#pragma once

#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft {

struct RepairOptions {
    double target_angle = 30;  // degrees; tetrahedra with a worse least dihedral angle are worked on
    int passes = 15;
    int sweeps = 1;            // guarded centroid smoothing sweeps of the whole mesh first
    const double* point_size = nullptr;  // wanted edge length at each point, or null
};

// Flips and smoothing; points on a flat part of the hull stay in it, exactly for planes across an axis.
// Never makes a tetrahedron worse than the worst that it replaces. Notes background.repair.*.
void repair(TetMesh& mesh, const RepairOptions& options, const Run& run);

}  // namespace cleft
