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
    // Where an output goes: behind a link, since the pieces of a list lie beside the list. A link whose file has
    // another extension stands for itself, as the extension says the format.
    static std::string target_of(const std::string& output);
    // The files that so many ranks make of an output besides the one of its path.
    static std::vector<std::string> pieces_of(const std::string& output, int ranks);
    // Throws a Failure for outputs that no run could write.
    void check_outputs(int ranks) const;

private:
    void add_sharing_to(CLI::App& parser);
};

}  // namespace cleft_mpi_cli
