// Which labels the lists STRIP and ONLY of the options keep.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "capi/handles.hpp"
#include "volume/kept_materials.hpp"

namespace cleft::capi
{

// The labels that have these numbers.
Array<UserLabel> user_labels(const int32_t* numbers, int64_t count);

// By the place of a label in `labels`, which for a volume is its material. An Error if the options leave all of them
// out. `whose` is what has the labels, in words: "volume" or "mesh".
KeptMaterials kept_labels(const Array<UserLabel>& labels, const cleft_options* options, const char* whose);

// Warns of labels that the lists name and that are not among `labels`.
void warn_of_unknown_labels(const Array<UserLabel>& labels, const cleft_options* options, const char* whose,
                            const Run& run);

// Takes out of a mesh what the options leave out.
void strip_labels(cleft_mesh& mesh, const cleft_options* options);

}  // namespace cleft::capi
