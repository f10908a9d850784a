// The charge of a sizing field: the integral of h^-3 over the box, from which numbers of tetrahedra follow.
#pragma once

#include "sizing/sizing_field.hpp"

#include <functional>

namespace cleft
{

// Integral of h^-3 over the voxels that count (all, if `counts` is null), as the field is interpolated.
double sizing_charge(const SizingField& field, const std::function<bool(int64_t voxel)>& counts = nullptr);
}  // namespace cleft
