// Reports of ranks travel as the text that they have in the whole report.
#include "mpi/command/parts_report.hpp"

#include "cli/findings.hpp"
#include "cli/handles.hpp"
#include "cli/json_report.hpp"

#include <algorithm>
#include <utility>

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
    const auto mesh = session.make<cleft_cli::Mesh>(cleft_cli::EXIT_MESHING_FAILED, [&](cleft_mesh** out) {
        return cleft_mesh_create(session.context(), n.points, cleft_part_points(part), n.owned_tets,
                                 cleft_part_tets(part), cleft_part_tet_labels(part), 0, out);
    });
    cleft_quality quality{};
    quality.struct_size = sizeof quality;
    session.check(cleft_mesh_quality(session.context(), mesh.get(), &quality), cleft_cli::EXIT_MESHING_FAILED);
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

// How a figure of the whole comes from those of parts. Medians and means do not: edges are in several parts.
enum class Joining { kLeast, kGreatest, kSum };
constexpr std::pair<const char*, Joining> kJoinedFigures[] = {
    {"min_dihedral", Joining::kLeast}, {"max_dihedral", Joining::kGreatest},     {"tets_below_5", Joining::kSum},
    {"tets_below_10", Joining::kSum},  {"tets_below_15", Joining::kSum},         {"tets_below_20", Joining::kSum},
    {"tets_above_165", Joining::kSum}, {"radius_ratio_max", Joining::kGreatest}, {"edge_ratio_max", Joining::kGreatest},
    {"min_edge", Joining::kLeast},     {"max_edge", Joining::kGreatest},         {"min_volume", Joining::kLeast},
    {"total_volume", Joining::kSum},
};

Json whole_quality(const Json& ranks)
{
    Json joined;
    for (const Json& rank : ranks) {
        const Json& own = rank["quality"];
        if (own.is_null())
            continue;
        const bool is_first = joined.is_null();
        for (const auto& [field, joining] : kJoinedFigures) {
            if (is_first)
                joined[field] = own[field];
            else if (joining == Joining::kSum)
                add_field(joined, own, field);
            else if (joining == Joining::kLeast ? own[field] < joined[field] : own[field] > joined[field])
                joined[field] = own[field];
        }
        if (is_first)
            joined["dihedral_histogram"] = std::vector<int64_t>(own["dihedral_histogram"].size());
        for (std::size_t bin = 0; bin < own["dihedral_histogram"].size(); ++bin)
            joined["dihedral_histogram"][bin] =
                joined["dihedral_histogram"][bin].get<int64_t>() + own["dihedral_histogram"][bin].get<int64_t>();
    }
    return joined;
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
    const cleft_part_counts n = counts_of(session, part);
    const Json report = {{"mesh", cleft_cli::mesh_json(own_mesh(n, part))},
                         {"quality", own_quality(session, n, part)},
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
    Json report = cleft_cli::report_head("mesh");
    report["inputs"] = arguments.volume.inputs;
    report["outputs"] = arguments.outputs;
    report["options"] = arguments.options.as_json(options);
    report["volume"] = cleft_cli::grid_json(grid_of(voxels));
    report["mesh"] = whole_mesh(all);
    report["quality"] = whole_quality(all);
    report["ranks"] = all;
    cleft_cli::add_run(report, session);
    return report;
}

}  // namespace cleft_mpi_cli
