// What is left to do for volumes after the chords: smooth interfaces of a label map hold not quite as much as its
// voxels.
#pragma once

#include "base/array.hpp"
#include "volume/volume.hpp"

namespace cleft
{

// A piece of interface.
struct SharedArea {
    Material first, second;
    double area;
};

// An offset for each material, such that each gains the volume it is missing when every interface moves towards its
// second material by the offset of the first less that of the second: as pressures move the films of a foam. The least
// such offsets. What materials that touch miss in sum, and what one misses that touches none, is left out.
Array<double> material_offsets(const Array<SharedArea>& shared, const Array<double>& missing);

}  // namespace cleft
