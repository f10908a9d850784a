// Meshes from and to files.
#pragma once

#include "output_files.hpp"
#include "session.hpp"
#include "staged_outputs.hpp"

#include <string>
#include <vector>

namespace cleft_cli
{

// Throws Failure with EXIT_CANNOT_READ.
Mesh read_mesh(const Session& session, const std::string& path);

// To be committed when all else is done.
void write_mesh(const Session& session, const cleft_mesh* mesh, const std::vector<OutputFile>& outputs,
                StagedOutputs& staged);

// --msh-version, for checked_mesh_output().
void add_msh_version_to(CLI::App& app, std::string& version);

}  // namespace cleft_cli
