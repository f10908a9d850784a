// cleft check: is a mesh sound?
#include "checked_mesh.hpp"
#include "commands.hpp"
#include "guarded.hpp"
#include "json_report.hpp"
#include "mesh_files.hpp"
#include "output_conflicts.hpp"
#include "standard_output.hpp"
#include "summary.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace cleft_cli
{
namespace
{

struct CheckArguments {
    std::string mesh;
    bool fills_box = false;
    RunArguments run;
};

void write_report(const Session& session, const CheckArguments& arguments, const CheckedMesh& mesh)
{
    auto report = report_head("check");
    report["inputs"] = {arguments.mesh};
    report["validation"] = validation_json(mesh.validation, mesh.fault);
    report["mesh"] = mesh_json(mesh.found);
    report["quality"] = quality_json(mesh.found.quality);
    add_run(report, session);
    write_json(report, arguments.run.json);
}

int run_check(const CheckArguments& arguments)
{
    refuse_conflicts({arguments.mesh}, {}, arguments.run.json);
    // Before the mesh is read: a report that cannot be written must not cost the reading of a large
    // file.
    check_json_output(arguments.run.json);
    Session session(arguments.run, {{"read", 1}, {"check", 1}});
    Mesh mesh;
    session.timed("read", "reading the mesh", [&] { mesh = read_mesh(session, arguments.mesh); });
    CheckedMesh checked;
    session.timed("check", "checking the mesh",
                  [&] { checked = check_mesh(session, mesh.get(), arguments.fills_box); });
    // The bar shares the terminal with what is printed next.
    session.clear_progress();
    if (arguments.run.prints())
        print_summary_text(validation_lines(checked.validation, checked.fault) + mesh_lines(checked.found) + "\n" +
                           dihedral_histogram(checked.found.quality));
    if (!arguments.run.json.empty())
        write_report(session, arguments, checked);
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
    arguments->run.add_to(parser);
    parser.footer("Formats of MESH, by extension:\n" + format_help(CLEFT_IO_READS_MESH) +
                  "\nExamples:\n  cleft check atlas.vtu\n  cleft check box.msh --fills-box --json -\n\n" +
                  exit_code_help());
    return {&parser, [arguments] { return guarded("check", arguments->run, [&] { return run_check(*arguments); }); }};
}

}  // namespace cleft_cli
