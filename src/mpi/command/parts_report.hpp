// The machine-readable report of `cleft-mpi mesh`, in the fields of `cleft mesh`. docs/scale.md describes the others.
#pragma once

#include "cleft/cleft_parts.h"
#include "mpi/command/counted_exchange.hpp"
#include "mpi/command/parts_arguments.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace cleft_mpi_cli
{

// What a rank tells of itself: its own points and tetrahedra, and what the run cost it.
std::string rank_report(const cleft_cli::Session& session, const cleft_part* part, const std::vector<Sent>& sent);

// The report of all: of the whole mesh, and of what the ranks told, in their order. Figures of the run are those of
// this rank.
nlohmann::ordered_json parts_report(const cleft_cli::Session& session, const PartsArguments& arguments,
                                    const cleft_options* options, const cleft_voxels& voxels, const cleft_part* part,
                                    const cleft_quality& quality, const std::vector<std::string>& ranks);

}  // namespace cleft_mpi_cli
