// What the command reports to a person, as text.
#pragma once

#include "findings.hpp"

#include <functional>
#include <string>
#include <vector>

namespace cleft_cli
{

// All functions give whole lines, each with its end.
std::string summary_line(const std::string& heading, const std::string& text);
std::string volume_line(const VolumeFindings& volume);
// A row a label: voxels, volume, and share of the voxels of the box.
std::string labels_table(const VolumeFindings& volume);
// A row a label: tetrahedra, volume, and share of the volume of the mesh.
std::string labels_table(const MeshFindings& mesh);

// The extreme angles, and how many tetrahedra have small ones.
std::string angles_line(const cleft_quality& quality);
// Counts, angles and shapes: some lines.
std::string mesh_lines(const MeshFindings& mesh);
// A bar for each bin of 5 degrees that has an angle.
std::string dihedral_histogram(const cleft_quality& quality);

// The same of lengths, shapes and angles by a metric.
std::string metric_lines(const cleft_metric_quality& quality);
std::string dihedral_histogram(const cleft_metric_quality& quality);

// One line a label; at most `limit` of them, those whose volumes differ most.
std::string label_report_table(const std::vector<LabelFindings>& rows,
                               const std::function<bool(int32_t label)>& left_out, std::size_t limit);

// The interfaces and lines, and how far the mesh is from them. Above `limit` those that are farthest off.
std::string distances_table(std::vector<cleft_distance> rows, const VolumeFindings& volume, std::size_t limit);

// Seconds by the clock and of all threads, and the peak of memory of the process.
std::string time_line(const Session& session, int64_t tets);
// Seconds by the clock, their share of the run, seconds of all threads, and the peak of memory up to the end of each
// stage. Stages within another one stand under it.
std::string stages_table(const Session& session);
// `first_fault` is the library's sentence, "" for a valid mesh.
std::string validation_lines(const cleft_validation& validation, const std::string& first_fault);

}  // namespace cleft_cli
