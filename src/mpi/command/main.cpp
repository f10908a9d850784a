// The command `cleft-mpi`, run by mpirun. It uses the public headers of the libraries, and shares with `cleft` what
// both have of arguments, progress and signals.
#include "cli/command_line.hpp"
#include "cli/exit_code.hpp"
#include "cli/last_words.hpp"
#include "cli/standard_output.hpp"
#include "mpi/command/parts_command.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>

namespace
{

using cleft_mpi_cli::Ranks;

int parse_and_run(int argc, char** argv, const Ranks& ranks)
{
    CLI::App app;
    const auto run = cleft_mpi_cli::add_parts_command(app);
    cleft_cli::describe(app, "Makes conforming multi-material tetrahedral meshes on several processes, by MPI.",
                        "  mpirun -n 8 cleft-mpi mesh rock.h5 -o rock.vtkhdf\n");
    const auto said = cleft_cli::parse_words(app, argc, argv);
    if (!said)
        return run(ranks);
    // All ranks have the same words before them.
    if (ranks.is_first() && said->is_complaint)
        std::fputs(said->text.c_str(), stderr);
    if (ranks.is_first() && !said->is_complaint)
        cleft_cli::print_summary_text(said->text);
    return said->is_complaint ? cleft_cli::EXIT_USAGE : cleft_cli::EXIT_OK;
}

}  // namespace

int main(int argc, char** argv)
{
    cleft_cli::make_streams_safe();
    cleft_cli::tell_of_want_of_memory();
    const Ranks ranks(&argc, &argv);
    try {
        return parse_and_run(argc, argv, ranks);
        // Failures that all ranks know do not come here. Of one rank alone, as of a closed standard output, the others
        // do not hear, and may wait.
    } catch (const cleft_cli::Failure& failure) {
        std::fprintf(stderr, "cleft-mpi: %s\n", failure.what());
        Ranks::end_all(failure.exit_code);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "cleft-mpi: %s\n", error.what());
        Ranks::end_all(cleft_cli::EXIT_MESHING_FAILED);
    }
}
