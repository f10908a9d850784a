// Writes pages by the file component.
#include "view_page.hpp"

#include "label_names.hpp"
#include "number_checks.hpp"

#include "cleft/cleft_io.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>

namespace cleft_cli
{
namespace
{

// So many of the last parts of a path, or all of them.
std::string end_of_path(const std::string& path, size_t parts)
{
    std::filesystem::path rest(path);
    // A path that ends in "/" has no name behind it.
    if (!rest.has_filename())
        rest = rest.parent_path();
    std::filesystem::path end = rest.filename();
    for (rest = rest.parent_path(); parts > 1 && rest.has_filename(); rest = rest.parent_path(), --parts)
        end = rest.filename() / end;
    return parts > 1 ? path : end.string();
}

}  // namespace

void PageArguments::add_to(CLI::App& app)
{
    add_names_to(app, names, "Names of labels in the view");
    app.add_option("--goal", goal,
                   "Least dihedral angle that the view marks, in degrees (default:\n"
                   "that of the report, else 25)")
        ->check(number_above_zero(90))
        ->type_name("DEGREES");
    app.add_option("--max-shown", max_tets,
                   "Tetrahedra that the view has of a mesh at most (default\n"
                   "3000000). Of more it has those at interfaces, and says so")
        ->check(positive_integer())
        ->type_name("N");
}

std::vector<std::string> file_titles(const std::vector<std::string>& paths)
{
    const auto titles_of = [&](size_t parts) {
        std::vector<std::string> titles(paths.size());
        std::transform(paths.begin(), paths.end(), titles.begin(),
                       [&](const std::string& path) { return end_of_path(path, parts); });
        return titles;
    };
    std::vector<std::string> titles = titles_of(1);
    // One file, if its path is given twice, has one name.
    for (size_t parts = 2; titles.size() == 2 && titles[0] == titles[1] && paths[0] != paths[1]; ++parts)
        titles = titles_of(parts);
    return titles;
}

void write_page(const Session& session, const std::vector<ShownMesh>& meshes, const PageArguments& arguments,
                StagedOutputs& staged)
{
    const auto text_or_null = [](const std::string& text) { return text.empty() ? nullptr : text.c_str(); };
    cleft_io_view view = {};
    view.struct_size = sizeof view;
    view.max_tets = arguments.max_tets;
    view.goal = arguments.goal;
    view.names = text_or_null(arguments.names);
    view.title = text_or_null(meshes.front().title);
    view.report = text_or_null(meshes.front().report);
    if (meshes.size() > 1) {
        view.other = meshes[1].mesh;
        view.other_title = text_or_null(meshes[1].title);
        view.other_report = text_or_null(meshes[1].report);
    }
    staged.write(arguments.output, [&](const std::string& to) {
        const cleft_status status = cleft_io_write_view(session.context(), meshes.front().mesh, &view, to.c_str());
        // Only the table of names has a format.
        session.check(status, status == CLEFT_ERROR_FORMAT ? EXIT_CANNOT_READ : EXIT_CANNOT_WRITE);
    });
}

}  // namespace cleft_cli
