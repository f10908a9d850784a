// Reads tables of names by the file component.
#include "label_names.hpp"

#include "exit_code.hpp"

#include "cleft/cleft_io.h"

#include <CLI/CLI.hpp>

namespace cleft_cli
{

void add_names_to(CLI::App& app, std::string& path, const std::string& what)
{
    app.add_option("--names", path,
                   what + ": a label and its name a line,\nor a table of ITK-SNAP, FreeSurfer, MRIcron or BIDS")
        ->check(CLI::ExistingFile.description(""))
        ->type_name("FILE");
}

void read_names(const Session& session, const std::string& path, cleft_volume* volume)
{
    if (!path.empty())
        session.check(cleft_io_read_volume_names(session.context(), path.c_str(), volume), EXIT_CANNOT_READ);
}

void read_names(const Session& session, const std::string& path, cleft_mesh* mesh)
{
    if (!path.empty())
        session.check(cleft_io_read_mesh_names(session.context(), path.c_str(), mesh), EXIT_CANNOT_READ);
}

}  // namespace cleft_cli
