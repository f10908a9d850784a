// From a user's label values to dense materials and back.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "mesh/user_label.hpp"

#include <cstdint>

namespace cleft
{

// Materials are stored in 16 bits at most, and material_set.hpp keeps one number free.
constexpr size_t kGreatestLabelCount = 65535;

[[noreturn]] void refuse_label_count();

// The different values among n voxels in the order in which they come there: materials are numbered so, and another
// choice of values gives the same mesh. Refuses values past INT32_MAX and more than 65,535 different ones.
template <class Value>
Array<UserLabel> distinct_labels(const Value* voxels, int64_t n, const Run& run);

// out[i] = place of voxels[i] in `labels`.
template <class Value, class Label>
void dense_materials(const Value* voxels, int64_t n, const Array<UserLabel>& labels, Label* out, const Run& run);

}  // namespace cleft
