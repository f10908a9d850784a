// The files of a run: all ranks write them, and the first one gives them their names.
#pragma once

#include "cleft/cleft_parts.h"
#include "cli/session.hpp"
#include "cli/staged_outputs.hpp"
#include "mpi/command/parts_arguments.hpp"
#include "mpi/command/ranks.hpp"

namespace cleft_mpi_cli
{

// Of a run of more ranks, pieces stay that a pattern such as "m_*.vtu" would take for pieces of this mesh.
void warn_of_old_pieces(const Ranks& ranks, cleft_cli::Session& session, const PartsArguments& arguments);

// To be committed by the first rank when all else is done.
void write_outputs(const Ranks& ranks, cleft_cli::Session& session, const PartsArguments& arguments,
                   const cleft_part* part, cleft_cli::StagedOutputs& staged);

}  // namespace cleft_mpi_cli
