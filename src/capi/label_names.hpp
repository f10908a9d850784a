// What the labels of a volume or a mesh are called.
#pragma once

#include "base/array.hpp"

#include <cstdint>
#include <map>
#include <string>

namespace cleft::capi
{

// Labels without a name are not in it. A map: a name stays where it is while others are added.
using LabelNames = std::map<int32_t, std::string>;

// Sets or (null or "") removes the name of a label. An Error if `labels` (ascending or not) lacks the label, or if the
// name is not one line of UTF-8.
void set_label_name(LabelNames& names, const Array<int32_t>& labels, int32_t label, const char* name,
                    const char* owner);

// "" if the label has none.
const char* label_name(const LabelNames& names, int32_t label);

// Adds those of `more` that are of one of `labels` (ascending) and have no name yet.
void add_label_names(LabelNames& names, const LabelNames& more, const Array<int32_t>& labels);

}  // namespace cleft::capi
