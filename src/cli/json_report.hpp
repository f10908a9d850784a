// The machine-readable report. docs/guide.md describes its fields.
#pragma once

#include "findings.hpp"
#include "staged_outputs.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

namespace cleft_cli
{

// Program, version and command: the beginning of every report.
nlohmann::ordered_json report_head(const std::string& command);

// Where the voxels are, without what they are.
nlohmann::ordered_json grid_json(const VolumeFindings& volume);
nlohmann::ordered_json volume_json(const VolumeFindings& volume);
nlohmann::ordered_json mesh_json(const MeshFindings& mesh);
nlohmann::ordered_json quality_json(const cleft_quality& quality);
nlohmann::ordered_json metric_quality_json(const cleft_metric_quality& quality);
// `first_fault` is "" for a valid mesh.
nlohmann::ordered_json validation_json(const cleft_validation& validation, const std::string& first_fault);
// `left_out` answers whether the user left a label out of the mesh.
nlohmann::ordered_json label_reports_json(const std::vector<LabelFindings>& rows,
                                          const std::function<bool(int32_t label)>& left_out);
nlohmann::ordered_json contacts_json(const std::vector<cleft_contact>& contacts);
nlohmann::ordered_json distances_json(const std::vector<cleft_distance>& distances);

// Adds what the run cost and reported: stages, metrics, warnings.
void add_run(nlohmann::ordered_json& report, const Session& session);

// As text, whatever bytes paths have.
std::string json_text(const nlohmann::ordered_json& report);
// "-" is standard output. A file is to be committed when all else is done. Throws Failure.
void write_json(const nlohmann::ordered_json& report, const std::string& path, StagedOutputs& staged);
void write_json(const nlohmann::ordered_json& report, const std::string& path);

}  // namespace cleft_cli
