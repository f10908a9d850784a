// cleft convert: a mesh from one format to another, or some of its labels.
#include "commands.hpp"
#include "guarded.hpp"
#include "json_report.hpp"
#include "label_names.hpp"
#include "mesh_files.hpp"
#include "option_arguments.hpp"
#include "output_conflicts.hpp"
#include "standard_output.hpp"
#include "text.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace cleft_cli
{
namespace
{

struct ConvertArguments {
    std::string from, to, names;
    std::string msh_version = "4.1";
    OptionArguments options;
    RunArguments run;
};

void write_report(const Session& session, const ConvertArguments& arguments, const cleft_mesh* mesh,
                  StagedOutputs& staged)
{
    auto report = report_head("convert");
    report["inputs"] = {arguments.from};
    report["outputs"] = {arguments.to};
    report["points"] = cleft_mesh_point_count(mesh);
    report["tets"] = cleft_mesh_tet_count(mesh);
    add_run(report, session);
    write_json(report, arguments.run.json, staged);
}

int run_convert(const ConvertArguments& arguments)
{
    const Options options = arguments.options.make();
    refuse_conflicts({arguments.from, arguments.names}, {arguments.to}, arguments.run.json);
    // All mistakes of usage are found before a file is read.
    const OutputFile output = checked_mesh_output(arguments.to, arguments.msh_version);
    check_json_output(arguments.run.json);
    Session session(arguments.run, {{"read", 2}, {"strip", 1}, {"write", 1}});
    Mesh mesh;
    session.timed("read", "reading the mesh", [&] {
        mesh = read_mesh(session, arguments.from);
        read_names(session, arguments.names, mesh.get());
    });
    session.timed("strip", "leaving labels out", [&] {
        // Also without lists of labels: the call then copies the mesh, and the code has one way.
        mesh = session.make<Mesh>(EXIT_MESHING_FAILED, [&](cleft_mesh** out) {
            return cleft_mesh_strip(session.context(), mesh.get(), options.get(), out);
        });
    });
    // The mesh and the report appear together, after both are written.
    StagedOutputs staged;
    session.timed("write", "writing", [&] { write_mesh(session, mesh.get(), {output}, staged); });
    session.clear_progress();
    if (!arguments.run.json.empty())
        write_report(session, arguments, mesh.get(), staged);
    // Printed before the commit: if standard output is full, the command fails and leaves no file.
    if (arguments.run.prints())
        print_summary_text(plural(cleft_mesh_tet_count(mesh.get()), "tetrahedron", "tetrahedra") + ", " +
                           plural(cleft_mesh_point_count(mesh.get()), "point") + " written to " + arguments.to + "\n");
    staged.commit();
    return EXIT_OK;
}

}  // namespace

Command add_convert_command(CLI::App& app)
{
    auto arguments = std::make_shared<ConvertArguments>();
    CLI::App& parser = *app.add_subcommand("convert", "Write a mesh in another format");
    parser.add_option("A", arguments->from, "The mesh to read")->required()->type_name("");
    parser.add_option("B", arguments->to, "The file to write")->required()->type_name("");
    add_msh_version_to(parser, arguments->msh_version);
    add_names_to(parser, arguments->names, "Names of labels in the file");
    arguments->options.add_label_lists_to(parser);
    arguments->run.add_to(parser);
    parser.footer(
        "Formats that can be read:\n" + format_help(CLEFT_IO_READS_MESH) + "\nFormats that can be written:\n" +
        format_help(CLEFT_IO_WRITES_MESH) +
        "\nExamples:\n  cleft convert head.vtu head.inp --strip 0\n  cleft convert head.msh interfaces.stl\n\n" +
        exit_code_help());
    return {&parser,
            [arguments] { return guarded("convert", arguments->run, [&] { return run_convert(*arguments); }); }};
}

}  // namespace cleft_cli
