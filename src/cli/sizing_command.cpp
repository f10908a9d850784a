// cleft sizing: the sizing field of a volume, as a volume to look at or to change.
#include "commands.hpp"
#include "findings.hpp"
#include "guarded.hpp"
#include "json_report.hpp"
#include "metric_arguments.hpp"
#include "option_arguments.hpp"
#include "output_conflicts.hpp"
#include "output_files.hpp"
#include "standard_output.hpp"
#include "summary.hpp"
#include "text.hpp"
#include "volume_arguments.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace cleft_cli
{
namespace
{

struct SizingArguments {
    VolumeArguments input;
    OptionArguments options;
    MetricArguments metric;
    bool combine = false;
    RunArguments run;
    std::string output;
};

struct FieldFigures {
    double least = 0, median = 0, greatest = 0, tets = 0;
};

FieldFigures look_at_field(const cleft_sizing* sizing, const VolumeFindings& volume)
{
    const float* values = cleft_sizing_values(sizing);
    // A copy: the field itself must keep its order.
    std::vector<float> sorted(values, values + volume.voxel_count());
    // nth_element() and not sort(): a field has as many values as the volume has voxels.
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const auto [least, greatest] = std::minmax_element(sorted.begin(), sorted.end());
    return {*least, *middle, *greatest, cleft_sizing_expected_tets(sizing)};
}

Sizing make_sizing(Session& session, const SizingArguments& arguments, const cleft_volume* volume,
                   const cleft_options* options)
{
    Sizing sizing;
    session.timed("sizing", "sizing field", [&] {
        if (arguments.metric.given()) {
            cleft_io_reading reading = arguments.input.reading();
            reading.scale = 1;  // as `cleft mesh` reads it
            sizing = arguments.metric.read(session, volume, reading, arguments.combine, options);
            return;
        }
        sizing = session.make<Sizing>(EXIT_MESHING_FAILED, [&](cleft_sizing** out) {
            return cleft_sizing_create(session.context(), volume, options, out);
        });
    });
    return sizing;
}

void write_field(Session& session, const SizingArguments& arguments, const cleft_sizing* sizing, StagedOutputs& staged)
{
    session.timed("write", "writing", [&] {
        staged.write(arguments.output, [&](const std::string& to) {
            session.check(cleft_io_write_sizing(session.context(), sizing, to.c_str(), arguments.input.world_number()),
                          EXIT_CANNOT_WRITE);
        });
    });
}

void write_report(const Session& session, const SizingArguments& arguments, const cleft_options* options,
                  const VolumeFindings& volume, const FieldFigures& field, StagedOutputs& staged)
{
    auto report = report_head("sizing");
    report["inputs"] = arguments.input.inputs;
    report["outputs"] = {arguments.output};
    report["world"] = arguments.input.world;
    report["options"] = arguments.options.as_json(options);
    if (arguments.metric.given())
        report["options"]["metric"] = arguments.metric.metric;
    report["volume"] = volume_json(volume);
    report["sizing"] = {
        {"least", field.least}, {"median", field.median}, {"greatest", field.greatest}, {"expected_tets", field.tets}};
    add_run(report, session);
    write_json(report, arguments.run.json, staged);
}

std::string field_lines(const FieldFigures& field)
{
    return summary_line("Sizes", significant(field.least) + " to " + significant(field.greatest) + ", median " +
                                     significant(field.median)) +
           summary_line("Estimate", rounded(field.tets) + " tetrahedra");
}

int run_sizing(const SizingArguments& arguments)
{
    const Options options = arguments.options.make();
    std::vector<std::string> inputs = arguments.input.inputs;
    inputs.push_back(arguments.metric.file());
    refuse_conflicts(inputs, {arguments.output}, arguments.run.json);
    check_sizing_output(arguments.output);
    check_json_output(arguments.run.json);
    Session session(arguments.run, {{"read", 1}, {"sizing", 8}, {"write", 1}});
    Volume volume;
    session.timed("read", "reading the volume", [&] { volume = arguments.input.read(session, options.get()); });
    const Sizing sizing = make_sizing(session, arguments, volume.get(), options.get());
    StagedOutputs staged;
    write_field(session, arguments, sizing.get(), staged);
    // After writing: the figures are for the summary, and the file does not wait for them.
    const VolumeFindings found = look_at_volume(session, volume.get());
    const FieldFigures field = look_at_field(sizing.get(), found);
    session.clear_progress();
    if (!arguments.run.json.empty())
        write_report(session, arguments, options.get(), found, field, staged);
    if (arguments.run.prints())
        print_summary_text(
            volume_line(found) + field_lines(field) +
            summary_line("Written", arguments.output + " (" + bytes_text(staged.bytes(arguments.output)) + ")"));
    // Last of all: whatever fails before leaves no output.
    staged.commit();
    return EXIT_OK;
}

}  // namespace

Command add_sizing_command(CLI::App& app)
{
    auto arguments = std::make_shared<SizingArguments>();
    CLI::App& parser =
        *app.add_subcommand("sizing", "Write the sizing field of a volume: the wanted edge length at each voxel");
    arguments->input.add_inputs_to(parser);
    parser.add_option("-o,--output", arguments->output, "The field, as a volume of float")
        ->required()
        ->type_name("FIELD");
    // The calls that this command makes. Options of meshing would have no effect here.
    arguments->options.add_to(parser, {"volume", "sizing"});
    arguments->options.add_label_sizes_to(parser);
    const std::string sizes = parser.get_option("--size")->get_group();
    arguments->metric.add_to(parser, kMetricHelp, sizes);
    parser
        .add_flag("--combine", arguments->combine,
                  "With --metric: no length is greater than that of the computed field")
        ->needs(parser.get_option("--metric"))
        ->group(sizes);
    arguments->options.add_label_lists_to(parser);
    arguments->input.add_reading_to(parser);
    arguments->run.add_to(parser);
    parser.footer(
        "Formats of FIELD, by extension:\n" + format_help(CLEFT_IO_WRITES_SIZING) +
        "\nExamples:\n  cleft sizing head.nrrd -o h.nrrd --gradation 0.2\n"
        "  cleft mesh head.nrrd --sizing h.nrrd -o head.vtu\n"
        "  cleft sizing head.nrrd -o h.nrrd --tets 500000 --strip 0      scaled for these tetrahedra\n"
        "  cleft mesh head.nrrd --sizing h.nrrd --strip 0 -o head.vtu    without --tets, which would scale again\n\n" +
        exit_code_help());
    return {&parser, [arguments] { return guarded("sizing", arguments->run, [&] { return run_sizing(*arguments); }); }};
}

}  // namespace cleft_cli
