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

}  // namespace cleft::capi
