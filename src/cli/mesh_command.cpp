// cleft mesh: from a volume to a mesh.
#include "checked_mesh.hpp"
#include "commands.hpp"
#include "findings.hpp"
#include "guarded.hpp"
#include "json_report.hpp"
#include "label_names.hpp"
#include "label_warnings.hpp"
#include "mesh_arguments.hpp"
#include "mesh_files.hpp"
#include "output_conflicts.hpp"
#include "standard_output.hpp"
#include "summary.hpp"
#include "terminal.hpp"
#include "text.hpp"

#include <CLI/CLI.hpp>

#include <unistd.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace cleft_cli
{
namespace
{

// The table of labels then fits one screen with the rest of the summary.
constexpr std::size_t kLabelsShown = 20;

struct Inputs {
    Volume volume;
    Sizing sizing;    // null: computed
    Mesh background;  // null: computed
};

// What is known when the mesh is done.
struct Result {
    VolumeFindings volume;
    MeshFindings mesh;
    std::optional<cleft_metric_quality> metric;
    ReportFindings report;  // contacts of kept labels only
    std::vector<OutputFile> outputs;
};

std::vector<OutputFile> checked_outputs(const MeshArguments& arguments)
{
    if (arguments.outputs.empty() && arguments.view.output.empty() && !arguments.estimate)
        throw usage_failure("--output is required (or --view, or --estimate)");
    std::vector<std::string> inputs = arguments.input.inputs;
    // Files that are read later are inputs, too: an output must not replace them.
    inputs.insert(inputs.end(),
                  {arguments.sizing_file, arguments.metric.file(), arguments.background_file, arguments.names});
    std::vector<std::string> written = arguments.outputs;
    if (!arguments.view.output.empty())
        written.push_back(arguments.view.output);
    refuse_conflicts(inputs, written, arguments.run.json);
    std::vector<OutputFile> outputs;
    for (const std::string& path : arguments.outputs)
        outputs.push_back(checked_mesh_output(path, arguments.msh_version));
    if (!arguments.view.output.empty())
        check_page_output(arguments.view.output);
    // A long run must not end with a report that cannot be written.
    check_json_output(arguments.run.json);
    return outputs;
}

Sizing read_sizing(const Session& session, const MeshArguments& arguments, const cleft_volume* volume,
                   const cleft_options* options)
{
    cleft_io_reading reading = arguments.input.reading();
    reading.scale = 1;  // the field is in the unit of the mesh, as `cleft sizing` writes it
    if (arguments.metric.given())
        return arguments.metric.read(session, volume, reading, arguments.combine, options);
    return session.make<Sizing>(EXIT_CANNOT_READ, [&](cleft_sizing** out) {
        return cleft_io_read_sizing(session.context(), volume, arguments.sizing_file.c_str(), &reading,
                                    arguments.combine ? 1 : 0, options, out);
    });
}

Inputs read_inputs(Session& session, const MeshArguments& arguments, const cleft_options* options)
{
    Inputs inputs;
    session.timed("read", "reading the volume", [&] {
        inputs.volume = arguments.input.read(session, options);
        read_names(session, arguments.names, inputs.volume.get());
    });
    if (!arguments.sizing_file.empty() || arguments.metric.given())
        session.timed(arguments.metric.given() ? "read_metric" : "read_sizing", "reading the sizing field",
                      [&] { inputs.sizing = read_sizing(session, arguments, inputs.volume.get(), options); });
    if (!arguments.background_file.empty())
        session.timed("read_background", "reading the background",
                      [&] { inputs.background = read_mesh(session, arguments.background_file); });
    return inputs;
}

std::string estimate_lines(const cleft_estimate& estimate)
{
    std::string text =
        summary_line("Estimate", (estimate.is_rough != 0 ? "roughly " : "") + rounded(estimate.tets) +
                                     " tetrahedra, about " + bytes_text(estimate.peak_bytes) + " of memory");
    // Labels that are left out are meshed first and removed at the end, so they cost memory and
    // time.
    if (estimate.whole_tets > 1.01 * estimate.tets)
        text += summary_line("", "of " + rounded(estimate.whole_tets) + " with the labels that are left out");
    return text;
}

int tell_estimate(Session& session, const MeshArguments& arguments, const Inputs& inputs, const cleft_options* options)
{
    cleft_estimate estimate{};
    estimate.struct_size = sizeof estimate;
    session.timed("estimate", "estimating", [&] {
        session.check(cleft_mesh_estimate(session.context(), inputs.volume.get(), inputs.sizing.get(),
                                          inputs.background.get(), options, &estimate),
                      EXIT_MESHING_FAILED);
    });
    const VolumeFindings found = look_at_volume(session, inputs.volume.get());
    session.clear_progress();
    if (arguments.run.prints())
        print_summary_text(volume_line(found) + estimate_lines(estimate));
    if (!arguments.run.json.empty()) {
        auto report = report_head("mesh");
        report["volume"] = volume_json(found);
        report["estimate"] = {{"tets", estimate.tets},
                              {"whole_tets", estimate.whole_tets},
                              {"background_tets", estimate.background_tets},
                              {"peak_bytes", estimate.peak_bytes},
                              {"is_rough", estimate.is_rough != 0}};
        add_run(report, session);
        write_json(report, arguments.run.json);
    }
    return EXIT_OK;
}

Mesh make_mesh(Session& session, const Inputs& inputs, const cleft_options* options)
{
    Mesh mesh;
    session.timed("mesh", "meshing", [&] {
        mesh = session.make<Mesh>(EXIT_MESHING_FAILED, [&](cleft_mesh** out) {
            return cleft_mesh_volume(session.context(), inputs.volume.get(), inputs.sizing.get(),
                                     inputs.background.get(), options, out);
        });
    });
    return mesh;
}

// Looks at the mesh for what it finds, and validates it. It fills its box unless a label of the volume was left out of
// it, or the background is the user's.
MeshFindings checked_findings(Session& session, const MeshArguments& arguments, const cleft_volume* volume,
                              const cleft_mesh* mesh)
{
    bool whole = arguments.background_file.empty();
    for (int64_t i = 0; i < cleft_volume_label_count(volume); ++i)
        whole = whole && !arguments.left_out(cleft_volume_labels(volume)[i]);
    CheckedMesh checked;
    session.timed("check", "checking the mesh", [&] { checked = check_mesh(session, mesh, whole); });
    // It is not written, as somebody would use it all the same.
    if (!checked.valid())
        throw Failure(EXIT_CHECK_FAILED, CLEFT_ERROR_INVALID_MESH,
                      "the mesh is not valid, and was not written: " + checked.fault);
    return checked.found;
}

// The findings without the contacts of labels that are left out.
ReportFindings kept_contacts(const MeshArguments& arguments, ReportFindings found)
{
    auto& contacts = found.contacts;
    contacts.erase(std::remove_if(contacts.begin(), contacts.end(),
                                  [&](const cleft_contact& contact) {
                                      return arguments.left_out(contact.first) || arguments.left_out(contact.second);
                                  }),
                   contacts.end());
    return found;
}

// Who waited for a run at a terminal wants to know what took so long.
bool shows_stages(const Session& session, const MeshArguments& arguments)
{
    constexpr double kLongSeconds = 5;
    return arguments.run.verbose || (is_terminal(STDOUT_FILENO) && session.elapsed_seconds() >= kLongSeconds);
}

void print_summary(const Session& session, const MeshArguments& arguments, const Result& result,
                   const StagedOutputs& staged)
{
    const auto left_out = [&](int32_t label) { return arguments.left_out(label); };
    const std::size_t limit = arguments.run.verbose ? result.report.labels.size() : kLabelsShown;
    std::string text = volume_line(result.volume) + mesh_lines(result.mesh) +
                       (result.metric ? metric_lines(*result.metric) : "") + "\n" +
                       dihedral_histogram(result.mesh.quality) + "\n" +
                       (result.metric ? dihedral_histogram(*result.metric) + "\n" : "") +
                       label_report_table(result.report.labels, left_out, limit) +
                       distances_table(result.report.distances, result.volume, limit) + "\n";
    if (shows_stages(session, arguments))
        text += stages_table(session) + "\n";
    text += time_line(session, result.mesh.tets);
    std::vector<std::string> written;
    for (const OutputFile& output : result.outputs)
        written.push_back(output.path);
    if (!arguments.view.output.empty())
        written.push_back(arguments.view.output);
    for (const std::string& path : written) {
        // 0 where the file cannot be looked at.
        const double bytes = staged.bytes(path);
        text += summary_line("Written", path + (bytes > 0 ? " (" + bytes_text(bytes) + ")" : ""));
    }
    print_summary_text(text);
}

nlohmann::ordered_json report_of(const Session& session, const MeshArguments& arguments, const cleft_options* options,
                                 const Result& result)
{
    auto report = report_head("mesh");
    report["inputs"] = arguments.input.inputs;
    report["outputs"] = arguments.outputs;
    if (!arguments.view.output.empty())
        report["view"] = arguments.view.output;
    if (!arguments.names.empty())
        report["names"] = arguments.names;
    report["world"] = arguments.input.world;
    report["options"] = arguments.options.as_json(options);
    // The option holds the name of a kind, and the run used the file instead.
    if (!arguments.background_file.empty())
        report["options"]["background"] = arguments.background_file;
    report["options"]["sizing"] = arguments.sizing_file;
    if (arguments.metric.given())
        report["options"]["metric"] = arguments.metric.metric;
    report["volume"] = volume_json(result.volume);
    report["mesh"] = mesh_json(result.mesh);
    report["quality"] = quality_json(result.mesh.quality);
    if (result.metric)
        report["metric_quality"] = metric_quality_json(*result.metric);
    report["labels"] =
        label_reports_json(result.report.labels, [&](int32_t label) { return arguments.left_out(label); });
    report["contacts"] = contacts_json(result.report.contacts);
    if (arguments.distances)
        report["distances"] = distances_json(result.report.distances);
    add_run(report, session);
    return report;
}

void look_at_result(Session& session, const MeshArguments& arguments, const cleft_volume* volume,
                    const cleft_mesh* mesh, Result& result)
{
    session.timed("report", "looking at the mesh", [&] {
        result.volume = look_at_volume(session, volume);
        if (!arguments.check)
            result.mesh = look_at_mesh(session, mesh);
        session.begin_part("labels", "looking at the labels");
        result.report = kept_contacts(arguments, look_at_labels(session, volume, mesh, arguments.distances));
    });
    warn_of_labels(session, result.report, [&](int32_t label) { return arguments.left_out(label); });
}

// What the view calls the mesh: its file, or that of the volume.
std::string title_of(const MeshArguments& arguments)
{
    return file_titles({arguments.outputs.empty() ? arguments.input.inputs.front() : arguments.outputs.front()})
        .front();
}

// The mesh and what is reported of it: all files or none.
void write_result(Session& session, const MeshArguments& arguments, const cleft_mesh* mesh,
                  const cleft_options* options, const Result& result)
{
    StagedOutputs staged;
    session.timed("write", "writing", [&] { write_mesh(session, mesh, result.outputs, staged); });
    if (!arguments.view.output.empty())
        session.timed("view", "writing the view", [&] {
            const std::string report = json_text(report_of(session, arguments, options, result));
            write_page(session, {{mesh, title_of(arguments), report}}, arguments.view, staged);
        });
    session.clear_progress();
    if (!arguments.run.json.empty())
        write_json(report_of(session, arguments, options, result), arguments.run.json, staged);
    if (arguments.run.prints())
        print_summary(session, arguments, result, staged);
    // Last of all: whatever fails before leaves no output and no part of one.
    staged.commit();
}

int run_mesh(MeshArguments& arguments)
{
    // Before make(), which would refuse a path as a kind of background.
    arguments.background_file = arguments.options.take_background_file();
    const Options options = arguments.options.make();
    Result result;
    result.outputs = checked_outputs(arguments);
    Session session(arguments.run, arguments.parts());

    Inputs inputs = read_inputs(session, arguments, options.get());
    if (arguments.estimate)
        return tell_estimate(session, arguments, inputs, options.get());
    const Mesh mesh = make_mesh(session, inputs, options.get());
    if (arguments.metric.given() && arguments.has_report())
        session.timed("metric", "measuring by the metric",
                      [&] { result.metric = look_at_metric(session, mesh.get(), inputs.sizing.get()); });
    // Fields and background are as large as the volume or the mesh. They are not needed any more,
    // and the report takes memory.
    inputs.sizing.reset();
    inputs.background.reset();
    if (arguments.check)
        result.mesh = checked_findings(session, arguments, inputs.volume.get(), mesh.get());
    if (arguments.has_report())
        look_at_result(session, arguments, inputs.volume.get(), mesh.get(), result);
    // The voxels have been compared with the mesh. Writers need memory for the surface.
    inputs.volume.reset();
    write_result(session, arguments, mesh.get(), options.get(), result);
    return EXIT_OK;
}

}  // namespace

Command add_mesh_command(CLI::App& app)
{
    auto arguments = std::make_shared<MeshArguments>();
    CLI::App& parser = *app.add_subcommand("mesh", "Make a mesh of a volume");
    arguments->add_to(parser);
    return {&parser, [arguments] { return guarded("mesh", arguments->run, [&] { return run_mesh(*arguments); }); }};
}

}  // namespace cleft_cli
