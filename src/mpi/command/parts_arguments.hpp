// What `cleft-mpi mesh` is asked to do.
#pragma once

#include "cli/option_arguments.hpp"
#include "cli/session.hpp"
#include "cli/volume_arguments.hpp"

#include <string>
#include <vector>

namespace cleft_mpi_cli
{

// It must outlive the CLI::App, which writes into it while it parses.
struct PartsArguments {
    cleft_cli::VolumeArguments volume;
    cleft_cli::OptionArguments options;
    cleft_cli::RunArguments run;
    std::vector<std::string> outputs;
    std::string dataset;
    std::string scratch;
    std::string memory;
    bool ghosts = false;

    void add_to(CLI::App& parser);

    const std::string& input() const { return volume.inputs.front(); }
    bool is_hdf5() const;
    // Where a rank keeps what it does not work on; empty: in memory.
    std::string scratch_folder() const;
    // Throws a Failure for outputs that no run could write.
    void check_outputs() const;

private:
    void add_sharing_to(CLI::App& parser);
};

}  // namespace cleft_mpi_cli
