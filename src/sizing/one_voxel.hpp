// The parts of materials that are one voxel thick.
#pragma once

#include "base/array.hpp"
#include "sizing/labelling.hpp"
#include "sizing/voxel_rows.hpp"

#include <cstdint>

namespace cleft
{

// For each voxel 1 if it is in a part of its material that is one voxel thick (a sheet, a rod, a speck, however they
// lie), or shares a face with one that is; else 0. One voxel thick is what no block of 2 x 2 x 2 voxels of the material
// reaches. Past the faces of the grid the outermost voxels repeat.
Array<uint8_t> near_one_voxel_parts(const Labelling& labelling, const Run& run);

}  // namespace cleft
