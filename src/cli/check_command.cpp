// cleft check: is a mesh sound?
#include "commands.hpp"
#include "findings.hpp"
#include "guarded.hpp"
#include "json_report.hpp"
#include "output_conflicts.hpp"
#include "output_files.hpp"
#include "standard_output.hpp"
#include "summary.hpp"

#include "cleft/cleft_io.h"

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

int run_check(const CheckArguments& arguments)
{
    refuse_conflicts({arguments.mesh}, {}, arguments.run.json);
    // Before the mesh is read: a report that cannot be written must not cost the reading of a large
    // file.
    check_json_output(arguments.run.json);
    Session session(arguments.run);
    cleft_validation validation = {};
    validation.struct_size = sizeof validation;
    std::string fault;
    MeshFindings found;
    Mesh mesh;
    session.timed("read", "reading the mesh", [&] {
        mesh = session.make<Mesh>(EXIT_CANNOT_READ, [&](cleft_mesh** out) {
            return cleft_io_read_mesh(session.context(), arguments.mesh.c_str(), out);
        });
    });
    session.timed("check", "checking the mesh", [&] {
        session.check(cleft_mesh_validate(session.context(), mesh.get(), arguments.fills_box ? 1 : 0, &validation),
                      EXIT_MESHING_FAILED);
        // The sentence of the first fault is left on the context, which the next call of the
        // library forgets.
        if (validation.valid == 0)
            fault = cleft_context_last_error(session.context());
        found = look_at_mesh(session, mesh.get());
        // A second opinion: the validator and the surface count the same faces by code of their
        // own.
        if (validation.valid != 0) {
            fault = surface_fault(validation, found);
            validation.valid = fault.empty();
        }
    });
    // The bar shares the terminal with what is printed next.
    session.clear_progress();
    if (arguments.run.prints())
        print_summary_text(validation_lines(validation, fault) + mesh_lines(found) + "\n" +
                           dihedral_histogram(found.quality));
    if (!arguments.run.json.empty()) {
        auto report = report_head("check");
        report["inputs"] = {arguments.mesh};
        report["validation"] = validation_json(validation, fault);
        report["mesh"] = mesh_json(found);
        report["quality"] = quality_json(found.quality);
        add_run(report, session);
        write_json(report, arguments.run.json);
    }
    // Not a Failure: the check was done, and its answer is the exit code.
    return validation.valid != 0 ? EXIT_OK : EXIT_CHECK_FAILED;
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
