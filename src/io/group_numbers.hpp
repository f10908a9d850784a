// The numbers of volumes and of groups of triangles, in every format that has both.
#pragma once

#include "io/mesh_view.hpp"

namespace cleft::io
{

// Fills MeshView::volume_numbers and SurfaceGroup::number: positive, and no two the same, as some readers keep the
// numbers of volumes and of surfaces in one list. A positive label is its own number; other labels get the least
// numbers that are free. Groups follow the greatest number of a volume; where 32 bits end too soon, each of them gets
// the least number that is free.
void number_groups(MeshView& mesh);

}  // namespace cleft::io
