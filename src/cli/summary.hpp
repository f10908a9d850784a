// What the command tells a person, as text.
#pragma once

#include "findings.hpp"

#include <functional>
#include <string>
#include <vector>

namespace cleft_cli
{

// All functions give whole lines, each with its end.
std::string volume_line(const VolumeFindings& volume);
std::string labels_table(const VolumeFindings& volume);
std::string labels_table(const MeshFindings& mesh);

// Counts, angles and shapes: some lines.
std::string mesh_lines(const MeshFindings& mesh);
std::string dihedral_histogram(const cleft_quality& quality);

// One line a label; at most `limit` of them, those whose volumes differ most.
std::string label_report_table(const std::vector<LabelFindings>& rows,
                               const std::function<bool(int32_t label)>& left_out, std::size_t limit);

// Seconds by the clock and of all threads, and the peak of memory of the process.
std::string time_line(const Session& session, int64_t tets);
std::string stages_table(const Session& session);
std::string validation_lines(const cleft_validation& validation, const std::string& first_fault);

}  // namespace cleft_cli
