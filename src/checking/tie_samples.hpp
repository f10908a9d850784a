// Places of the triangles and lines of a mesh at which their distance from the volume is measured.
#pragma once

#include "base/array.hpp"
#include "base/placement.hpp"
#include "checking/tie_elements.hpp"

namespace cleft
{

struct TieSample {
    TieMaterials of;
    FixedArray<int32_t, 3> corner;  // it is the mean of these points, of which the first is -1 at the middle of an edge
    double weight;                  // the area or length that it stands for

    Vec3 place(const Array<Vec3>& points) const;
};

// Sorted by materials. A corner or an edge of several triangles of the same materials is there once.
Array<TieSample> tie_samples(const Array<TieElement>& elements, const Array<Vec3>& points, const Placement& world);

}  // namespace cleft
