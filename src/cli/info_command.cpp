// cleft info: what is in a volume or a mesh.
#include "commands.hpp"
#include "findings.hpp"
#include "guarded.hpp"
#include "json_report.hpp"
#include "label_names.hpp"
#include "mesh_files.hpp"
#include "output_conflicts.hpp"
#include "standard_output.hpp"
#include "summary.hpp"
#include "volume_arguments.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace cleft_cli
{
namespace
{

struct InfoArguments {
    VolumeArguments input;
    std::string names;
    RunArguments run;
};

// With --dims the file is raw voxels whatever its name says. Several files are always volumes.
bool is_mesh(const InfoArguments& arguments)
{
    return arguments.input.dims.empty() && arguments.input.inputs.size() == 1 &&
           cleft_io_guess(arguments.input.inputs.front().c_str()) == CLEFT_IO_MESH;
}

std::string affine_lines(const VolumeFindings& volume)
{
    std::string text;
    for (std::size_t row = 0; row < 3; ++row) {
        // Four numbers of "%.6g" have at most 13 characters each.
        char buffer[160];
        const double* a = volume.affine.data() + 4 * row;
        std::snprintf(buffer, sizeof buffer, "%-11s%11.6g %11.6g %11.6g   %12.6g\n", row == 0 ? "Affine" : "", a[0],
                      a[1], a[2], a[3]);
        text += buffer;
    }
    return text;
}

int tell_volume(Session& session, const InfoArguments& arguments)
{
    VolumeFindings found;
    session.timed("read", "reading the volume", [&] {
        // Without options: they change nothing that is reported here.
        const Volume volume = arguments.input.read(session, nullptr);
        read_names(session, arguments.names, volume.get());
        found = look_at_volume(session, volume.get());
    });
    session.clear_progress();
    if (arguments.run.prints())
        print_summary_text(volume_line(found) + affine_lines(found) + "\n" + labels_table(found));
    if (!arguments.run.json.empty()) {
        auto report = report_head("info");
        report["inputs"] = arguments.input.inputs;
        report["world"] = arguments.input.world;
        report["volume"] = volume_json(found);
        add_run(report, session);
        write_json(report, arguments.run.json);
    }
    return EXIT_OK;
}

int tell_mesh(Session& session, const InfoArguments& arguments)
{
    MeshFindings found;
    session.timed("read", "reading the mesh", [&] {
        const Mesh mesh = read_mesh(session, arguments.input.inputs.front());
        read_names(session, arguments.names, mesh.get());
        found = look_at_mesh(session, mesh.get());
    });
    session.clear_progress();
    if (arguments.run.prints())
        print_summary_text(mesh_lines(found) + "\n" + dihedral_histogram(found.quality) + "\n" + labels_table(found));
    if (!arguments.run.json.empty()) {
        auto report = report_head("info");
        report["inputs"] = arguments.input.inputs;
        report["mesh"] = mesh_json(found);
        report["quality"] = quality_json(found.quality);
        add_run(report, session);
        write_json(report, arguments.run.json);
    }
    return EXIT_OK;
}

}  // namespace

Command add_info_command(CLI::App& app)
{
    auto arguments = std::make_shared<InfoArguments>();
    CLI::App& parser = *app.add_subcommand("info", "Tell what is in a volume or a mesh");
    arguments->input.add_inputs_to(parser);
    // The argument is shared with `mesh` and `sizing`, which take no meshes.
    parser.get_option("INPUT")->description("A volume (or several indicator functions) or a mesh");
    arguments->input.add_reading_to(parser);
    add_names_to(parser, arguments->names, "Names of labels");
    arguments->run.add_to(parser);
    parser.footer("Examples:\n  cleft info atlas.nii.gz\n  cleft info atlas.vtu --json -\n\n" +
                  std::string(exit_code_help()));
    // The shared pointer is copied into the function, so that the values live until it has run.
    const auto run = [arguments] {
        std::vector<std::string> inputs = arguments->input.inputs;
        inputs.push_back(arguments->names);
        refuse_conflicts(inputs, {}, arguments->run.json);
        check_json_output(arguments->run.json);
        Session session(arguments->run, {{"read", 1}});
        return is_mesh(*arguments) ? tell_mesh(session, *arguments) : tell_volume(session, *arguments);
    };
    return {&parser, [arguments, run] { return guarded("info", arguments->run, run); }};
}

}  // namespace cleft_cli
