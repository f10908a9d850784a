// cleft render: a picture of a mesh, without a screen.
#include "commands.hpp"
#include "guarded.hpp"
#include "json_report.hpp"
#include "label_names.hpp"
#include "mesh_files.hpp"
#include "output_conflicts.hpp"
#include "picture_arguments.hpp"
#include "standard_output.hpp"
#include "text.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace cleft_cli
{
namespace
{

struct RenderArguments {
    std::string mesh, output, names;
    PictureArguments picture;
    RunArguments run;
};

void write_picture(const Session& session, const RenderArguments& arguments, const cleft_mesh* mesh,
                   const cleft_io_picture& picture, StagedOutputs& staged)
{
    const std::vector<int32_t>& strip = arguments.picture.strip();
    const std::vector<int32_t>& whole = arguments.picture.whole();
    staged.write(arguments.output, [&](const std::string& to) {
        const cleft_status status =
            cleft_io_write_picture(session.context(), mesh, strip.data(), static_cast<int64_t>(strip.size()),
                                   whole.data(), static_cast<int64_t>(whole.size()), &picture, to.c_str());
        // A value that the library refuses came from the command line.
        session.check(status, status == CLEFT_ERROR_ARGUMENT ? EXIT_USAGE : EXIT_CANNOT_WRITE);
    });
}

void write_report(const Session& session, const RenderArguments& arguments, const cleft_mesh* mesh,
                  const cleft_io_picture& picture, StagedOutputs& staged)
{
    auto report = report_head("render");
    report["inputs"] = {arguments.mesh};
    report["outputs"] = {arguments.output};
    report["tets"] = cleft_mesh_tet_count(mesh);
    report["width"] = picture.width;
    report["height"] = picture.height;
    add_run(report, session);
    write_json(report, arguments.run.json, staged);
}

int run_render(const RenderArguments& arguments)
{
    const cleft_io_picture picture = arguments.picture.make();
    refuse_conflicts({arguments.mesh, arguments.names}, {arguments.output}, arguments.run.json);
    check_picture_output(arguments.output);
    check_json_output(arguments.run.json);
    Session session(arguments.run, {{"read", 1}, {"render", 1}});
    Mesh mesh;
    session.timed("read", "reading the mesh", [&] {
        mesh = read_mesh(session, arguments.mesh);
        read_names(session, arguments.names, mesh.get());
    });
    StagedOutputs staged;
    session.timed("render", "drawing", [&] { write_picture(session, arguments, mesh.get(), picture, staged); });
    session.clear_progress();
    if (!arguments.run.json.empty())
        write_report(session, arguments, mesh.get(), picture, staged);
    if (arguments.run.prints())
        print_summary_text(std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                           " pixels written to " + arguments.output + " (" +
                           bytes_text(staged.bytes(arguments.output)) + ")\n");
    staged.commit();
    return EXIT_OK;
}

}  // namespace

Command add_render_command(CLI::App& app)
{
    auto arguments = std::make_shared<RenderArguments>();
    CLI::App& parser = *app.add_subcommand("render", "Draw a mesh as a picture, without a screen");
    parser.add_option("MESH", arguments->mesh, "A mesh of tetrahedra")->required()->type_name("");
    parser.add_option("-o,--output", arguments->output, "The picture, a PNG file")->required()->type_name("PICTURE");
    add_names_to(parser, arguments->names, "Names of labels in the legend");
    arguments->picture.add_to(parser);
    arguments->run.add_to(parser);
    parser.footer("Formats of MESH, by extension:\n" + format_help(CLEFT_IO_READS_MESH) +
                  "\nExamples:\n  cleft render head.vtu -o head.png --cut y=0.5\n"
                  "  cleft render head.vtu -o corner.png --cut x=0.5,y=0.5,z=0.6 --strip 0 --legend\n"
                  "  cleft render head.vtu -o angles.png --by angle --legend --background dark\n\n" +
                  exit_code_help());
    return {&parser, [arguments] { return guarded("render", arguments->run, [&] { return run_render(*arguments); }); }};
}

}  // namespace cleft_cli
