// The sizing field of a volume.
#pragma once

#include "sizing/compute.hpp"
#include "sizing/sizing_field.hpp"
#include "sizing/sizing_options.hpp"

namespace cleft
{

// The three distance transforms of the paper (section 3, Sizing Field), then limits, user's field and gradation.
// Throws for options that contradict each other or are no sizes. Warns of what it changes or does not use.
SizingField compute_sizing(const Volume& volume, const SizingOptions& options, const Run& run);

// The same with what sizes_for_error() finds. It is asked for where error_of_sizes() is above 0.
SizingField compute_sizing(const Volume& volume, const SizingOptions& options, const Array<SizeLimit>& limits,
                           const Run& run);
// 0 where one size is given for all places.
double error_of_sizes(const SizingOptions& options);

}  // namespace cleft
