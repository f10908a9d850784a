// cleft view: a page that shows a mesh in a browser, or two side by side.
#include "commands.hpp"
#include "guarded.hpp"
#include "json_report.hpp"
#include "mesh_files.hpp"
#include "mesh_report.hpp"
#include "output_conflicts.hpp"
#include "output_files.hpp"
#include "standard_output.hpp"
#include "text.hpp"
#include "view_page.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace cleft_cli
{
namespace
{

struct ViewArguments {
    std::vector<std::string> inputs;
    std::vector<std::string> reports;
    PageArguments page;
    RunArguments run;
};

void refuse_mistakes(const ViewArguments& arguments)
{
    if (arguments.reports.size() > arguments.inputs.size())
        throw usage_failure("there are more reports than meshes");
    std::vector<std::string> inputs = arguments.inputs;
    inputs.insert(inputs.end(), arguments.reports.begin(), arguments.reports.end());
    inputs.push_back(arguments.page.names);
    refuse_conflicts(inputs, {arguments.page.output}, arguments.run.json);
    check_page_output(arguments.page.output);
    check_json_output(arguments.run.json);
}

void write_report(const Session& session, const ViewArguments& arguments, const std::vector<Mesh>& meshes,
                  StagedOutputs& staged)
{
    auto report = report_head("view");
    report["inputs"] = arguments.inputs;
    report["outputs"] = {arguments.page.output};
    auto tets = nlohmann::ordered_json::array();
    for (const Mesh& mesh : meshes)
        tets.push_back(cleft_mesh_tet_count(mesh.get()));
    report["tets"] = tets;
    add_run(report, session);
    write_json(report, arguments.run.json, staged);
}

int run_view(const ViewArguments& arguments)
{
    refuse_mistakes(arguments);
    Session session(arguments.run, {{"read", 1}, {"write", 1}});
    std::vector<Mesh> meshes;
    std::vector<ShownMesh> shown;
    session.timed("read", "reading the mesh", [&] {
        const std::vector<std::string> titles = file_titles(arguments.inputs);
        for (size_t i = 0; i < arguments.inputs.size(); ++i) {
            const std::string& path = arguments.inputs[i];
            meshes.push_back(read_mesh(session, path));
            const cleft_mesh* mesh = meshes.back().get();
            const bool has_report = i < arguments.reports.size();
            shown.push_back({mesh, titles[i], has_report ? read_mesh_report(arguments.reports[i], mesh, path) : ""});
        }
    });
    StagedOutputs staged;
    session.timed("write", "writing", [&] { write_page(session, shown, arguments.page, staged); });
    session.clear_progress();
    if (!arguments.run.json.empty())
        write_report(session, arguments, meshes, staged);
    // Printed before the commit: if standard output is full, the command fails and leaves no file.
    if (arguments.run.prints())
        print_summary_text("Written " + arguments.page.output + " (" + bytes_text(staged.bytes(arguments.page.output)) +
                           "); open it in a browser\n");
    staged.commit();
    return EXIT_OK;
}

}  // namespace

Command add_view_command(CLI::App& app)
{
    auto arguments = std::make_shared<ViewArguments>();
    CLI::App& parser = *app.add_subcommand("view", "Write a page that shows a mesh in any browser");
    parser.add_option("MESH", arguments->inputs, "The mesh, or two meshes to compare")
        ->required()
        ->expected(1, 2)
        ->type_name("");
    parser.add_option("-o,--output", arguments->page.output, "The page: one file, which needs no network")
        ->required()
        ->type_name("FILE.html");
    parser
        .add_option("--report", arguments->reports,
                    "What `cleft mesh --json` reported of the mesh: the page then has\n"
                    "voxels against mesh, options and times. May be repeated for the\n"
                    "second mesh")
        ->allow_extra_args(false)
        ->check(CLI::ExistingFile.description(""))
        ->type_name("FILE");
    arguments->page.add_to(parser);
    arguments->run.add_to(parser);
    parser.footer("Formats that can be read:\n" + format_help(CLEFT_IO_READS_MESH) +
                  "\nExamples:\n"
                  "  cleft view head.vtu -o head.html\n"
                  "  cleft view head.vtu -o head.html --report head.json --names labels.txt\n"
                  "  cleft view coarse.vtu fine.vtu -o both.html          side by side, with one camera\n\n" +
                  exit_code_help());
    return {&parser, [arguments] { return guarded("view", arguments->run, [&] { return run_view(*arguments); }); }};
}

}  // namespace cleft_cli
