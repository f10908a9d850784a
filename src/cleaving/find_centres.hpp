// Makes the centres of a background.
#pragma once

#include "base/stage.hpp"
#include "cleaving/centres.hpp"

namespace cleft
{

// Samples the volume at the vertices, finds all centres, and chooses fans: three steps.
// `volume` and the tetrahedra of `background` are borrowed, and must outlive the centres. Points are copied, since
// snapping moves them. `metric` may be null.
Centres find_centres(const Volume& volume, const TetMesh& background, const MetricField* metric, Steps& steps);

// The part of it without geometry: fills the tables of edges, faces and tetrahedra from vertices of one material each.
void list_centres(Centres& c, const Run& run);

}  // namespace cleft
