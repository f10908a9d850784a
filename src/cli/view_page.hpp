// Pages that show meshes in a browser.
#pragma once

#include "session.hpp"
#include "staged_outputs.hpp"

#include <string>
#include <vector>

namespace cleft_cli
{

// A mesh of a page.
struct ShownMesh {
    const cleft_mesh* mesh = nullptr;
    std::string title;
    std::string report;  // JSON, or ""
};

struct PageArguments {
    std::string output;  // "": none is wanted
    std::string names;   // path of a table, or ""
    int64_t max_tets = 0;
    double goal = 0;

    // --names, --goal and --max-shown, which are for pages alone.
    void add_to(CLI::App& app);
};

// What a page calls the meshes of files or folders: their names, with as many of the folders that they are in as tell
// two of them apart.
std::vector<std::string> file_titles(const std::vector<std::string>& paths);

// One mesh, or two to compare. To be committed when all else is done.
void write_page(const Session& session, const std::vector<ShownMesh>& meshes, const PageArguments& arguments,
                StagedOutputs& staged);

}  // namespace cleft_cli
