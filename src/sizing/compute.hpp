// The sizing field of anything whose voxels have materials: compute_sizing without the Volume.
#pragma once

#include "base/array.hpp"
#include "sizing/labelling.hpp"
#include "sizing/sizing_field.hpp"
#include "sizing/sizing_options.hpp"

namespace cleft
{

// Throws if the greatest wanted size is less than the least.
void check_size_range(const SizingOptions& options);

// labels[m] is the user's value of material m, as in Volume::labels.
SizingField compute_sizing(const Labelling& labelling, const Array<int32_t>& labels, const SizingOptions& options,
                           const Run& run);

}  // namespace cleft
