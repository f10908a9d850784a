// The report of `cleft mesh --json` that goes with a mesh.
#pragma once

#include "session.hpp"

#include <string>

namespace cleft_cli
{

// The text of a report. Throws Failure unless it tells of this mesh: of as many points and tetrahedra, in the same
// labels and the same place. `mesh_path` is for the sentence.
std::string read_mesh_report(const std::string& path, const cleft_mesh* mesh, const std::string& mesh_path);

}  // namespace cleft_cli
