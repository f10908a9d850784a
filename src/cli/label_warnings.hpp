// Warnings of what the mesh does to labels that the voxels do not.
#pragma once

#include "findings.hpp"

#include <functional>

namespace cleft_cli
{

// Labels that the mesh lacks, whole or a piece of them, and labels that meet in it alone. `left_out` answers whether
// the user left a label out of the mesh.
void warn_of_labels(Session& session, const ReportFindings& report, const std::function<bool(int32_t label)>& left_out);

}  // namespace cleft_cli
