// How far beyond its tie each interface of a label map moves, for the volumes of the labels.
#pragma once

#include "base/array.hpp"
#include "fitting/interface_triangles.hpp"
#include "fitting/material_offsets.hpp"
#include "fitting/volume_deficits.hpp"

namespace cleft
{

// The pairs of materials that touch, each once, without areas.
Array<SharedArea> find_shared_areas(const Array<InterfaceTriangle>& triangles);

// Adds to the offsets of the triangles what the labels miss. The first round counts the heights as applied; later, what
// has not been applied will hardly be.
void add_offsets(const LocalMesh& mesh, const VolumeDeficits& deficits, const Vec3& spacing, bool first,
                 Array<SharedArea> shared, Array<InterfaceTriangle>& triangles, const Run& run);

}  // namespace cleft
