// The lengths of a cleaved mesh that is measured by a metric.
#pragma once

#include "base/run.hpp"
#include "remeshing/local_mesh.hpp"

namespace cleft
{

// Cleaving makes edges shorter than the metric asks for. Contracts them where nothing but shapes changes, and moves the
// points inside of materials until the others have good lengths. No angle gets worse than that which is given, in
// degrees, or than those around already are.
void improve_lengths(LocalMesh& mesh, double least_angle, const Run& run);

}  // namespace cleft
