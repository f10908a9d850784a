// Sizing fields with a metric: from values of a caller, and what changes all of their sizes.
#pragma once

#include "base/placement.hpp"
#include "sizing/sizing_field.hpp"

namespace cleft
{

// The greatest size over the least at one place. Orientations of tetrahedra are found in double precision: with far
// more, points of different places in a tetrahedron could no longer be told apart.
inline constexpr double kGreatestSizeRatio = 10000;

// Of six numbers for each voxel, in the order of Tensor: the metric of edges in the world, whose unit is that of
// `placement`. Throws an Error that names the first voxel whose tensor is not finite or not positive definite, or whose
// sizes or ratio of sizes are beyond what a field may have.
template <class Value>  // float or double
SizingField sizing_from_metric(const Grid& grid, const Placement& placement, const Value* values, const Run& run);
// The same tensor everywhere.
SizingField constant_metric(const Grid& grid, const Placement& placement, const Tensor& metric);

// Of tensors of the local frame, which must be positive definite.
SizingField sizing_of_tensors(const Grid& grid, const Array<Tensor>& metric, double gradation, const Run& run);

// The metric of edges in the world at a voxel of a field that has one.
Tensor world_metric(const SizingField& field, const Placement& placement, int64_t voxel);

// The sizes at the voxels in the direction in which they are greatest; those of the field if it has no metric.
SizingField greatest_sizes(const SizingField& field, const Run& run);

// Bounds the sizes of a metric in every direction; 0 stands for no bound.
void bound_metric(SizingField& field, double least, double greatest, const Run& run);
// No size of the metric is greater, in any direction, than that of the other field, which may have a metric, too.
void intersect_metric(SizingField& field, const SizingField& other, const Run& run);

}  // namespace cleft
