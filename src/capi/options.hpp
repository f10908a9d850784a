// From the handle of options to what the stages take.
#pragma once

#include "capi/handles.hpp"
#include "pipeline/pipeline.hpp"

namespace cleft::capi
{

// The value of an option; the default if `options` is null.
double option_value(const cleft_options* options, cleft_option key);

// What the pipeline takes; throws if `options` is not sound. Null gives the defaults.
PipelineOptions pipeline_options(const cleft_options* options);
// The same of a volume in this frame: shapes are measured in the world.
PipelineOptions pipeline_options(const cleft_options* options, const Frame& frame);
// And with what is said of labels, in terms of the volume's materials: which are kept, and their sizes. Throws if none
// is kept.
PipelineOptions pipeline_options(const cleft_options* options, const Frame& frame, const Array<UserLabel>& labels);
PipelineOptions pipeline_options(const cleft_options* options, const cleft_volume& volume);

// Warns of labels that have a size and that are not in the volume. It is for calls that compute sizes.
void warn_of_unknown_sizes(const Array<UserLabel>& labels, const cleft_options* options, const Run& run);

// Warns if SMOOTH was set and is not what the volume was made with: it takes effect there alone.
void warn_of_unused_smooth(const Volume& volume, const cleft_options* options, const Run& run);

}  // namespace cleft::capi
