// cleft check: is a mesh sound?
#include "checked_mesh.hpp"
#include "commands.hpp"
#include "guarded.hpp"
#include "json_report.hpp"
#include "mesh_files.hpp"
#include "metric_arguments.hpp"
#include "output_conflicts.hpp"
#include "standard_output.hpp"
#include "summary.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>

namespace cleft_cli
{
namespace
{

struct CheckArguments {
    std::string mesh;
    bool fills_box = false;
    MetricArguments metric;
    std::string world = "lps";
    RunArguments run;
};

using MetricFindings = std::optional<cleft_metric_quality>;

MetricFindings measured_by_metric(Session& session, const CheckArguments& arguments, const cleft_mesh* mesh)
{
    MetricFindings found;
    if (!arguments.metric.given())
        return found;
    session.timed("metric", "measuring by the metric", [&] {
        cleft_io_reading reading{};
        reading.struct_size = sizeof reading;
        reading.world = arguments.world == "ras" ? CLEFT_IO_WORLD_RAS : CLEFT_IO_WORLD_LPS;
        const Sizing sizing = arguments.metric.read(session, nullptr, reading, false, nullptr);
        found = look_at_metric(session, mesh, sizing.get());
    });
    return found;
}

void write_report(const Session& session, const CheckArguments& arguments, const CheckedMesh& mesh,
                  const MetricFindings& metric)
{
    auto report = report_head("check");
    report["inputs"] = {arguments.mesh};
    report["validation"] = validation_json(mesh.validation, mesh.fault);
    report["mesh"] = mesh_json(mesh.found);
    report["quality"] = quality_json(mesh.found.quality);
    if (arguments.metric.given()) {
        report["options"] = {{"metric", arguments.metric.metric}};
        // null where the mesh is too broken to be measured.
        report["metric_quality"] = metric ? metric_quality_json(*metric) : nlohmann::ordered_json();
    }
    add_run(report, session);
    write_json(report, arguments.run.json);
}

int run_check(const CheckArguments& arguments)
{
    refuse_conflicts({arguments.mesh, arguments.metric.file()}, {}, arguments.run.json);
    // Before the mesh is read: a report that cannot be written must not cost the reading of a large
    // file.
    check_json_output(arguments.run.json);
    std::vector<Part> parts{{"read", 1}, {"check", 1}};
    if (arguments.metric.given())
        parts.push_back({"metric", 1});
    Session session(arguments.run, parts);
    Mesh mesh;
    session.timed("read", "reading the mesh", [&] { mesh = read_mesh(session, arguments.mesh); });
    CheckedMesh checked;
    session.timed("check", "checking the mesh",
                  [&] { checked = check_mesh(session, mesh.get(), arguments.fills_box); });
    const MetricFindings metric = measured_by_metric(session, arguments, mesh.get());
    // The bar shares the terminal with what is printed next.
    session.clear_progress();
    if (arguments.run.prints())
        print_summary_text(validation_lines(checked.validation, checked.fault) + mesh_lines(checked.found) +
                           (metric ? metric_lines(*metric) : "") + "\n" + dihedral_histogram(checked.found.quality) +
                           (metric ? "\n" + dihedral_histogram(*metric) : ""));
    if (!arguments.run.json.empty())
        write_report(session, arguments, checked, metric);
    // Not a Failure: the check was done, and its answer is the exit code.
    return checked.valid() ? EXIT_OK : EXIT_CHECK_FAILED;
}

}  // namespace

Command add_check_command(CLI::App& app)
{
    // CLI11 keeps pointers to these values until the command has run.
    auto arguments = std::make_shared<CheckArguments>();
    CLI::App& parser =
        *app.add_subcommand("check", "Validate a mesh: exit code 1 and the first fault if it is not sound");
    parser.add_option("MESH", arguments->mesh, "A mesh of tetrahedra")->required()->type_name("");
    parser.add_flag("--fills-box", arguments->fills_box, "Also ask that the mesh fills its bounding box, sides planar");
    arguments->metric.add_to(parser,
                             "Measure edges, shapes and angles by a metric as well: a tensor for\n"
                             "each voxel, or one of six numbers everywhere",
                             "Metric");
    parser
        .add_option("--world", arguments->world,
                    "Directions of the coordinates of the mesh, for --metric (default lps)")
        ->check(CLI::IsMember({"lps", "ras"}).description(""))
        ->type_name("lps|ras")
        ->needs(parser.get_option("--metric"))
        ->group("Metric");
    arguments->run.add_to(parser);
    parser.footer("Formats of MESH, by extension:\n" + format_help(CLEFT_IO_READS_MESH) +
                  "\nExamples:\n  cleft check atlas.vtu\n  cleft check box.msh --fills-box --json -\n"
                  "  cleft check box.msh --metric metric.nrrd\n\n" +
                  exit_code_help());
    return {&parser, [arguments] { return guarded("check", arguments->run, [&] { return run_check(*arguments); }); }};
}

}  // namespace cleft_cli
