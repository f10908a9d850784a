// The slabs of a run whose user has not chosen any.
#pragma once

#include "cleft/cleft_parts.h"
#include "cli/session.hpp"
#include "mpi/command/parts_arguments.hpp"
#include "mpi/command/ranks.hpp"

namespace cleft_mpi_cli
{

// Sets the option `block` so that ranks share the work, or keep within --memory. The first rank says which slabs were
// chosen, since the mesh depends on them.
void choose_block(const Ranks& ranks, cleft_cli::Session& session, const PartsArguments& arguments,
                  const cleft_voxels& voxels, cleft_options* options);

}  // namespace cleft_mpi_cli
