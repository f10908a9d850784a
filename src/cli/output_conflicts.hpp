// Outputs that would take the place of something: reported before the work begins.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace cleft_cli
{

// Refuses, as a mistake of usage, an output that is an input or another output, by whatever path or link. Inputs may be
// folders and patterns of slices. `json` is the path of the report, or "" or "-"; what it replaces must be a report.
// `files_beside` gives the files that an output has besides the one of its path.
using FilesBeside = std::function<std::vector<std::string>(const std::string& output)>;
void refuse_conflicts(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs,
                      const std::string& json, const FilesBeside& files_beside = nullptr);

}  // namespace cleft_cli
