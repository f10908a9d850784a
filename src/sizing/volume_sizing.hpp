// The sizing field of a volume.
#pragma once

#include "sizing/sizing_field.hpp"
#include "sizing/sizing_options.hpp"

namespace cleft
{

// The three distance transforms of the paper (section 3, Sizing Field), then limits, user's field and gradation.
// Throws for options that contradict each other or are no sizes. Warns of what it changes or does not use.
SizingField compute_sizing(const Volume& volume, const SizingOptions& options, const Run& run);

}  // namespace cleft
