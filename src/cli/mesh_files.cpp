// Reads and writes meshes by the file component.
#include "mesh_files.hpp"

#include <CLI/CLI.hpp>

namespace cleft_cli
{

Mesh read_mesh(const Session& session, const std::string& path)
{
    return session.make<Mesh>(
        EXIT_CANNOT_READ, [&](cleft_mesh** out) { return cleft_io_read_mesh(session.context(), path.c_str(), out); });
}

void write_mesh(const Session& session, const cleft_mesh* mesh, const std::vector<OutputFile>& outputs,
                StagedOutputs& staged)
{
    for (const OutputFile& output : outputs)
        staged.write(output.path, [&](const std::string& to) {
            // The library checks the extension of `to`, which is staged under its final name.
            session.check(cleft_io_write_mesh(session.context(), mesh, to.c_str(), output.format), EXIT_CANNOT_WRITE);
        });
}

void add_msh_version_to(CLI::App& app, std::string& version)
{
    app.add_option("--msh-version", version, "Version of Gmsh's format for .msh (default 4.1)")
        ->check(CLI::IsMember({"4.1", "2.2"}).description(""))
        ->type_name("4.1|2.2");
}

}  // namespace cleft_cli
