// The command `cleft-mpi`, run by mpirun. It uses the public headers of the libraries, and shares with `cleft` what
// both have of arguments, progress and signals.
#include "cli/exit_code.hpp"
#include "cli/label_lists.hpp"
#include "cli/last_words.hpp"
#include "cli/standard_output.hpp"
#include "mpi/command/parts_command.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using cleft_mpi_cli::Ranks;

void describe(CLI::App& app)
{
    app.name("cleft-mpi");
    app.description("Makes conforming multi-material tetrahedral meshes on several processes, by MPI.");
    app.footer(std::string("Examples:\n"
                           "  mpirun -n 8 cleft-mpi mesh rock.h5 -o rock.vtkhdf\n"
                           "`cleft-mpi COMMAND --help` tells all options of a command.\n\n") +
               cleft_cli::exit_code_help());
    app.set_version_flag("--version", std::string("cleft-mpi ") + cleft_version(nullptr, nullptr, nullptr));
    app.require_subcommand(1);
}

int parse_and_run(int argc, char** argv, const Ranks& ranks)
{
    CLI::App app;
    describe(app);
    const auto run = cleft_mpi_cli::add_parts_command(app);
    for (CLI::App* command : app.get_subcommands({}))
        command->get_formatter()->column_width(32);
    std::vector<std::string> arguments(argv + 1, argv + argc);
    cleft_cli::join_label_lists(arguments);
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::ParseError& error) {
        // All ranks have the same words before them.
        std::ostringstream text, complaint;
        const bool is_wrong = app.exit(error, text, complaint) != 0;
        if (ranks.is_first() && is_wrong)
            std::fprintf(stderr, "cleft-mpi: %s", complaint.str().c_str());
        if (ranks.is_first() && !is_wrong)
            cleft_cli::print_summary_text(text.str());
        return is_wrong ? cleft_cli::EXIT_USAGE : cleft_cli::EXIT_OK;
    }
    return run(ranks);
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
