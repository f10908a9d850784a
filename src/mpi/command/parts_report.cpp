// Reports of ranks travel as the text that they have in the whole report.
#include "mpi/command/parts_report.hpp"

#include "cli/findings.hpp"
#include "cli/json_report.hpp"

#include <algorithm>

namespace cleft_mpi_cli
{
namespace
{

using Json = nlohmann::ordered_json;
using cleft_cli::MeshFindings;

cleft_part_counts counts_of(const cleft_cli::Session& session, const cleft_part* part)
{
    cleft_part_counts n{};
    n.struct_size = sizeof n;
    session.check(cleft_part_count(part, &n), cleft_cli::EXIT_MESHING_FAILED);
    return n;
}

MeshFindings own_mesh(const cleft_part_counts& n, const cleft_part* part)
{
    MeshFindings found;
    const double* points = cleft_part_points(part);
    found.take_points(points, n.owned_points);
    found.take_tets(points, cleft_part_tets(part), cleft_part_tet_labels(part), n.owned_tets);
    for (const auto& [label, totals] : found.labels)
        found.names[label] = "";
    const int32_t* sides = cleft_part_triangle_sides(part);
    found.interface_triangles = std::count(sides, sides + n.triangles, -1);
    found.hull_triangles = n.triangles - *found.interface_triangles;
    return found;
}

// Of the tetrahedra that the rank owns; null if it has none.
Json own_quality(const cleft_cli::Session& session, const cleft_part_counts& n, const cleft_part* part)
{
    if (n.owned_tets == 0)
        return {};
    cleft_quality quality{};
    quality.struct_size = sizeof quality;
    session.check(cleft_part_own_quality(session.context(), part, &quality), cleft_cli::EXIT_MESHING_FAILED);
    return cleft_cli::quality_json(quality);
}

Json sent_json(const std::vector<Sent>& sent)
{
    Json works = Json::array();
    int64_t messages = 0, bytes = 0;
    for (const Sent& some : sent) {
        works.push_back({{"name", some.work}, {"messages", some.messages}, {"bytes", some.bytes}});
        messages += some.messages;
        bytes += some.bytes;
    }
    return {{"messages", messages}, {"bytes", bytes}, {"work", works}};
}

// Adds a number of a rank.
void add_field(Json& sum, const Json& own, const char* field)
{
    if (own[field].is_number_float() || sum[field].is_number_float())
        sum[field] = sum[field].get<double>() + own[field].get<double>();
    else
        sum[field] = sum[field].get<int64_t>() + own[field].get<int64_t>();
}

void widen_box(Json& sum, const Json& own, bool is_first)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double low = own["low"][axis], high = own["high"][axis];
        sum["low"][axis] = is_first ? low : std::min(sum["low"][axis].get<double>(), low);
        sum["high"][axis] = is_first ? high : std::max(sum["high"][axis].get<double>(), high);
    }
}

// The meshes of all ranks as one.
Json whole_mesh(const Json& ranks, const std::vector<cleft_cli::LabelFindings>& labels)
{
    MeshFindings with_labels;
    for (const cleft_cli::LabelFindings& row : labels)
        if (row.tets > 0) {
            with_labels.labels[row.label] = {row.tets, row.mesh_volume};
            with_labels.names[row.label] = "";
        }
    Json sum = cleft_cli::mesh_json(with_labels);
    sum["interface_triangles"] = sum["hull_triangles"] = 0;
    for (const Json& rank : ranks) {
        const Json& own = rank["mesh"];
        if (own["points"] > 0)
            widen_box(sum, own, sum["points"] == 0);
        for (const char* field : {"points", "tets", "interface_triangles", "hull_triangles"})
            add_field(sum, own, field);
    }
    return sum;
}

// What became of each label of the volume, by label.
std::vector<cleft_cli::LabelFindings> labels_of(const cleft_cli::Session& session, const cleft_part* part)
{
    std::vector<cleft_cli::LabelFindings> rows(static_cast<std::size_t>(cleft_part_label_count(part)));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].struct_size = sizeof(cleft_label_report);
        session.check(cleft_part_label(part, static_cast<int64_t>(i), &rows[i]), cleft_cli::EXIT_MESHING_FAILED);
    }
    return rows;
}

// Nobody has counted pieces.
Json without_pieces(Json labels)
{
    for (Json& row : labels)
        for (const char* field : {"voxel_components", "mesh_components", "large_components", "large_components_lost",
                                  "large_components_broken", "large_components_joined"})
            row.erase(field);
    return labels;
}

cleft_cli::VolumeFindings volume_of(const cleft_voxels& voxels, const std::vector<cleft_cli::LabelFindings>& labels)
{
    cleft_cli::VolumeFindings volume;
    for (const cleft_cli::LabelFindings& row : labels) {
        volume.voxels[row.label] = row.voxels;
        volume.names[row.label] = "";
    }
    std::copy(voxels.dims, voxels.dims + 3, volume.dims.begin());
    std::copy(voxels.affine, voxels.affine + 12, volume.affine.begin());
    volume.take_spacing();
    return volume;
}

}  // namespace

std::string rank_report(const cleft_cli::Session& session, const cleft_part* part, const std::vector<Sent>& sent)
{
    const cleft_cli::StageFigures process = cleft_cli::process_figures();
    const cleft_part_counts n = counts_of(session, part);
    const Json report = {{"mesh", cleft_cli::mesh_json(own_mesh(n, part))},
                         {"quality", own_quality(session, n, part)},
                         {"cpu_seconds", process.cpu_seconds},
                         {"peak_bytes", process.peak_bytes},
                         {"sent", sent_json(sent)}};
    return cleft_cli::json_text(report);
}

Json parts_report(const cleft_cli::Session& session, const PartsArguments& arguments, const cleft_options* options,
                  const cleft_voxels& voxels, const cleft_part* part, const cleft_quality& quality,
                  const std::vector<std::string>& ranks)
{
    const std::vector<cleft_cli::LabelFindings> labels = labels_of(session, part);
    Json all = Json::array();
    for (const std::string& text : ranks)
        all.push_back(Json::parse(text));
    Json report = cleft_cli::report_head("mesh");
    report["inputs"] = arguments.volume.inputs;
    report["outputs"] = arguments.outputs;
    report["options"] = arguments.options.as_json(options);
    report["volume"] = cleft_cli::volume_json(volume_of(voxels, labels));
    report["mesh"] = whole_mesh(all, labels);
    report["quality"] = cleft_cli::quality_json(quality);
    report["labels"] = without_pieces(
        cleft_cli::label_reports_json(labels, [&](int32_t label) { return arguments.options.leaves_out(label); }));
    report["ranks"] = all;
    cleft_cli::add_run(report, session);
    return report;
}

}  // namespace cleft_mpi_cli
