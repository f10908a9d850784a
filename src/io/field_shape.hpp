// Tells functions from label maps by how their values lie.
#pragma once

#include "io/field_values.hpp"
#include "io/image.hpp"

namespace cleft::io
{

// Do many values lie at 0, or near several whole numbers, as those of a label map that somebody interpolated? A signed
// function passes through 0, and rests at most where it is cut off: at one number above 0 and the same below.
bool rests_on_labels(const Image& image, int64_t field, const FieldValues& values);

// Of whole numbers: do neighbours along some axis differ by one of the values that there are and not by more, as a
// distance does that was rounded, and as labels do not?
bool goes_step_by_step(const Image& image, int64_t field, const FieldValues& values);

}  // namespace cleft::io
