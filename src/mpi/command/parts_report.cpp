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

MeshFindings own_mesh(const cleft_cli::Session& session, const cleft_part* part)
{
    cleft_part_counts n{};
    n.struct_size = sizeof n;
    session.check(cleft_part_count(part, &n), cleft_cli::EXIT_MESHING_FAILED);
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

// Labels ascend in the report.
void add_labels(std::map<int32_t, Json>& sums, const Json& own)
{
    for (const Json& row : own["labels"]) {
        const auto [found, is_new] = sums.emplace(row["label"].get<int32_t>(), row);
        for (const char* field : {"tets", "volume"})
            if (!is_new)
                add_field(found->second, row, field);
    }
}

// The meshes of all ranks as one.
Json whole_mesh(const Json& ranks)
{
    Json sum = cleft_cli::mesh_json({});
    sum["interface_triangles"] = sum["hull_triangles"] = 0;
    std::map<int32_t, Json> labels;
    for (const Json& rank : ranks) {
        const Json& own = rank["mesh"];
        if (own["points"] > 0)
            widen_box(sum, own, sum["points"] == 0);
        for (const char* field : {"points", "tets", "interface_triangles", "hull_triangles"})
            add_field(sum, own, field);
        add_labels(labels, own);
    }
    for (const auto& [label, row] : labels)
        sum["labels"].push_back(row);
    return sum;
}

cleft_cli::VolumeFindings grid_of(const cleft_voxels& voxels)
{
    cleft_cli::VolumeFindings grid;
    std::copy(voxels.dims, voxels.dims + 3, grid.dims.begin());
    std::copy(voxels.affine, voxels.affine + 12, grid.affine.begin());
    grid.take_spacing();
    return grid;
}

}  // namespace

std::string rank_report(const cleft_cli::Session& session, const cleft_part* part, const std::vector<Sent>& sent)
{
    const cleft_cli::StageFigures process = cleft_cli::process_figures();
    const Json report = {{"mesh", cleft_cli::mesh_json(own_mesh(session, part))},
                         {"cpu_seconds", process.cpu_seconds},
                         {"peak_bytes", process.peak_bytes},
                         {"sent", sent_json(sent)}};
    return cleft_cli::json_text(report);
}

Json parts_report(const cleft_cli::Session& session, const PartsArguments& arguments, const cleft_options* options,
                  const cleft_voxels& voxels, const std::vector<std::string>& ranks)
{
    Json all = Json::array();
    for (const std::string& text : ranks)
        all.push_back(Json::parse(text));
    Json report = cleft_cli::report_head("mesh", "cleft-mpi");
    report["inputs"] = arguments.volume.inputs;
    report["outputs"] = arguments.outputs;
    report["options"] = arguments.options.as_json(options);
    report["volume"] = cleft_cli::grid_json(grid_of(voxels));
    report["mesh"] = whole_mesh(all);
    report["ranks"] = all;
    cleft_cli::add_run(report, session);
    return report;
}

}  // namespace cleft_mpi_cli
