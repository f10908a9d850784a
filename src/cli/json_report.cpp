// Makes the machine-readable report and writes it to a file, a device or standard output. Names of
// fields are an interface: scripts rely on them.
#include "json_report.hpp"

#include "program.hpp"
#include "standard_output.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace cleft_cli
{

// Ordered: fields come in the order in which they are added, so reports of two runs compare line by
// line.
using Json = nlohmann::ordered_json;

namespace
{

void write_text(const std::string& text, const std::string& path, bool is_new)
{
    const int descriptor = open_for_writing(path, is_new);
    int error = descriptor < 0 ? errno : write_all(descriptor, text);
    if (descriptor >= 0 && close(descriptor) != 0 && error == 0)
        error = errno;
    if (error == 0)
        return;
    Failure failure = failure_of_write(error, "cannot write '" + path + "'");
    // The report cannot tell of its own failure.
    failure.is_reported = false;
    throw failure;
}

}  // namespace

Json report_head(const std::string& command)
{
    return {{"program", kProgram}, {"version", cleft_version(nullptr, nullptr, nullptr)}, {"command", command}};
}

Json grid_json(const VolumeFindings& volume)
{
    return {{"dims", volume.dims},
            {"spacing", volume.spacing},
            {"affine", volume.affine},
            {"voxels", volume.voxel_count()}};
}

Json volume_json(const VolumeFindings& volume)
{
    Json labels = Json::array();
    for (const auto& [label, voxels] : volume.voxels)
        labels.push_back({{"label", label}, {"name", volume.names.at(label)}, {"voxels", voxels}});
    Json all = grid_json(volume);
    all["labels"] = labels;
    return all;
}

Json quality_json(const cleft_quality& q)
{
    return {{"min_dihedral", q.min_dihedral},
            {"max_dihedral", q.max_dihedral},
            {"tets_below_5", q.tets_below_5},
            {"tets_below_10", q.tets_below_10},
            {"tets_below_15", q.tets_below_15},
            {"tets_below_20", q.tets_below_20},
            {"tets_above_165", q.tets_above_165},
            {"radius_ratio_median", q.radius_ratio_median},
            {"radius_ratio_95", q.radius_ratio_95},
            {"radius_ratio_max", q.radius_ratio_max},
            {"edge_ratio_max", q.edge_ratio_max},
            {"min_edge", q.min_edge},
            {"mean_edge", q.mean_edge},
            {"max_edge", q.max_edge},
            {"min_volume", q.min_volume},
            {"total_volume", q.total_volume},
            {"dihedral_histogram", q.dihedral_histogram}};
}

Json metric_quality_json(const cleft_metric_quality& q)
{
    return {{"edges", q.edge_count},
            {"edges_in_range", q.edges_in_range},
            {"share_in_range",
             q.edge_count > 0 ? static_cast<double>(q.edges_in_range) / static_cast<double>(q.edge_count) : 0.0},
            {"edge_least", q.edge_least},
            {"edge_01", q.edge_01},
            {"edge_median", q.edge_median},
            {"edge_99", q.edge_99},
            {"edge_greatest", q.edge_greatest},
            {"mean_ratio_least", q.mean_ratio_least},
            {"mean_ratio_01", q.mean_ratio_01},
            {"mean_ratio_median", q.mean_ratio_median},
            {"min_dihedral", q.min_dihedral},
            {"max_dihedral", q.max_dihedral},
            {"dihedral_histogram", q.dihedral_histogram}};
}

Json mesh_json(const MeshFindings& mesh)
{
    Json labels = Json::array();
    for (const auto& [label, totals] : mesh.labels)
        labels.push_back(
            {{"label", label}, {"name", mesh.names.at(label)}, {"tets", totals.tets}, {"volume", totals.volume}});
    return {{"points", mesh.points},
            {"tets", mesh.tets},
            // null and not 0 where the mesh is too broken to have a surface.
            {"interface_triangles", mesh.interface_triangles ? Json(*mesh.interface_triangles) : Json()},
            {"hull_triangles", mesh.hull_triangles ? Json(*mesh.hull_triangles) : Json()},
            {"low", mesh.low},
            {"high", mesh.high},
            {"labels", labels}};
}

Json validation_json(const cleft_validation& v, const std::string& first_fault)
{
    return {{"valid", v.valid != 0},
            {"first_fault", first_fault},
            {"negative_tets", v.negative_tets},
            {"flat_tets", v.flat_tets},
            {"repeated_corners", v.repeated_corners},
            {"crowded_faces", v.crowded_faces},
            {"folded_faces", v.folded_faces},
            {"hull_off_box", v.hull_off_box},
            {"open_interface_edges", v.open_interface_edges},
            {"unused_points", v.unused_points},
            {"repeated_points", v.repeated_points},
            {"volume", v.volume},
            {"box_volume", v.box_volume},
            {"hull_area", v.hull_area},
            {"box_area", v.box_area},
            {"interface_triangles", v.interface_triangles},
            {"hull_triangles", v.hull_triangles}};
}

Json label_reports_json(const std::vector<LabelFindings>& rows, const std::function<bool(int32_t)>& left_out)
{
    Json labels = Json::array();
    for (const LabelFindings& row : rows)
        labels.push_back({{"label", row.label},
                          {"name", row.name},
                          {"left_out", left_out(row.label)},
                          // A label that the user left out is not lost.
                          {"lost", row.lost != 0 && !left_out(row.label)},
                          {"voxels", row.voxels},
                          {"tets", row.tets},
                          {"voxel_volume", row.voxel_volume},
                          {"mesh_volume", row.mesh_volume},
                          {"difference_percent", difference_percent(row)},
                          {"voxel_components", row.voxel_components},
                          {"mesh_components", row.mesh_components},
                          {"large_components", row.large_components},
                          {"large_components_lost", row.large_components_lost},
                          {"large_components_broken", row.large_components_broken},
                          {"large_components_joined", row.large_components_joined}});
    return labels;
}

Json contacts_json(const std::vector<cleft_contact>& contacts)
{
    Json all = Json::array();
    for (const cleft_contact& contact : contacts)
        all.push_back({{"labels", {contact.first, contact.second}}, {"triangles", contact.triangles}});
    return all;
}

Json distances_json(const std::vector<cleft_distance>& distances)
{
    Json all = Json::array();
    for (const cleft_distance& d : distances) {
        Json labels{d.first, d.second};
        if (d.is_line != 0)
            labels.push_back(d.third);
        all.push_back({{"labels", labels},
                       {d.is_line != 0 ? "edges" : "triangles", d.elements},
                       {"mesh", {{"mean", d.mesh_mean}, {"99", d.mesh_99}, {"greatest", d.mesh_greatest}}},
                       {"points", d.points},
                       {"volume", {{"mean", d.volume_mean}, {"99", d.volume_99}, {"greatest", d.volume_greatest}}}});
    }
    return all;
}

void add_run(Json& report, const Session& session)
{
    // An array, as the order of the stages matters and a name may come twice.
    Json stages = Json::array();
    for (const StageFigures& stage : session.stages()) {
        stages.push_back({{"name", stage.name},
                          {"part_of", stage.part_of},
                          {"seconds", stage.seconds},
                          {"cpu_seconds", stage.cpu_seconds},
                          {"peak_bytes", stage.peak_bytes}});
    }
    const StageFigures process = process_figures();
    report["threads"] = cleft_context_threads(session.context());
    report["seconds"] = session.elapsed_seconds();
    report["cpu_seconds"] = process.cpu_seconds;
    report["peak_bytes"] = process.peak_bytes;
    report["stages"] = stages;
    // A metric that was noted twice keeps its last value.
    Json metrics = Json::object();
    for (const auto& [name, value] : session.metrics())
        metrics[name] = value;
    report["metrics"] = metrics;
    report["warnings"] = session.warnings();
}

std::string json_text(const Json& report)
{
    // error_handler_t::replace: paths may be no UTF-8, and dump() would throw. A report with one
    // wrong character is better than none.
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_json(const Json& report, const std::string& path, StagedOutputs& staged)
{
    const std::string text = json_text(report);
    struct stat status = {};
    if (path == "-")
        print_report(text);
    // /dev/stderr, a pipe or /dev/null cannot be replaced by a rename, so the report is written to
    // them as they are.
    else if (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
        write_text(text, path, false);
    else
        staged.write(path, [&](const std::string& place) { write_text(text, place, true); });
}

void write_json(const Json& report, const std::string& path)
{
    StagedOutputs staged;
    write_json(report, path, staged);
    staged.commit();
}

}  // namespace cleft_cli
