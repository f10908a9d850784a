// cleft-mpi mesh: all ranks make a mesh of a volume, and write it together.
#pragma once

#include "mpi/command/ranks.hpp"

#include <functional>

namespace CLI
{
class App;
}

namespace cleft_mpi_cli
{

// Adds the command to the parser, which must outlive it. The answer runs it and gives the exit code.
std::function<int(const Ranks& ranks)> add_parts_command(CLI::App& app);

}  // namespace cleft_mpi_cli
