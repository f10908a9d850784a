// Metrics that do not grow faster than the gradation allows.
#pragma once

#include "base/run.hpp"
#include "metric/metric_field.hpp"

namespace cleft
{

// Tensors at the voxels of the grid, not their logarithms. Each becomes the intersection of its own with those of all
// others, grown on the way: the sizes of a metric M grow by the factor 1 + gradation |v|_M along a step v, in all
// directions (Alauzet 2010, homogeneous in the metric). So a flat element may stand beside a flat one, and grows in the
// thickness of some elements. Steps are those between neighbours along the axes.
void limit_metric_gradation(const Grid& grid, double gradation, Array<Tensor>& metric, const Run& run);

}  // namespace cleft
