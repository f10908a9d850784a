// What the stages find out, as the structs of the C interface.
#pragma once

#include "cleft/cleft.h"

#include "base/struct_size.hpp"
#include "mesh/quality.hpp"
#include "parts/part_labels.hpp"
#include "pipeline/label_report.hpp"

template <>
inline constexpr size_t cleft::kFirstSize<cleft_quality> = CLEFT_END_OF(cleft_quality, dihedral_histogram);
template <>
inline constexpr size_t cleft::kFirstSize<cleft_label_report> = CLEFT_END_OF(cleft_label_report, reserved);

namespace cleft::capi
{

cleft_quality row_of(const Quality& quality);
// Their volumes are as in the row.
cleft_label_report row_of(const LabelRow& label);
cleft_label_report row_of(const PartLabel& label);

}  // namespace cleft::capi
