// From a volume to its handle.
#pragma once

#include "capi/handles.hpp"

namespace cleft::capi
{

// With what callers are lent of it.
cleft_volume made_volume(const Frame& frame, Volume&& volume);

}  // namespace cleft::capi
