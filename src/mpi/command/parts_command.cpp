// Each step ends with an agreement of all ranks, and one of them prints.
#include "mpi/command/parts_command.hpp"

#include "cleft/cleft_mpi.h"
#include "cli/guarded.hpp"
#include "cli/json_report.hpp"
#include "cli/staged_outputs.hpp"
#include "cli/standard_output.hpp"
#include "cli/summary.hpp"
#include "cli/text.hpp"
#include "mpi/command/chosen_block.hpp"
#include "mpi/command/counted_exchange.hpp"
#include "mpi/command/memory_bound.hpp"
#include "mpi/command/parts_arguments.hpp"
#include "mpi/command/parts_outputs.hpp"
#include "mpi/command/parts_report.hpp"
#include "mpi/command/rank_voxels.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace cleft_mpi_cli
{
namespace
{

using cleft_cli::Failure;
using cleft_cli::Session;

struct DestroyPart {
    void operator()(cleft_part* part) const { cleft_part_destroy(part); }
};
using Part = std::unique_ptr<cleft_part, DestroyPart>;

std::string summary(const Session& session, const PartsArguments& arguments, const cleft_part* part,
                    const cleft_quality& quality)
{
    cleft_part_counts n{};
    n.struct_size = sizeof n;
    session.check(cleft_part_count(part, &n), cleft_cli::EXIT_MESHING_FAILED);
    std::string text = cleft_cli::summary_line("Mesh", cleft_cli::plural(n.all_points, "point") + ", " +
                                                           cleft_cli::plural(n.all_tets, "tetrahedron", "tetrahedra") +
                                                           " in " + cleft_cli::plural(n.ranks, "part"));
    text += cleft_cli::angles_line(quality);
    text += cleft_cli::summary_line("Time", cleft_cli::seconds_text(session.elapsed_seconds()));
    for (const std::string& path : arguments.outputs)
        text += cleft_cli::summary_line("Written", path);
    return text;
}

// A rank that hears of the failure of another has the same status, and knows no better code than that of writing.
int exit_code_of(cleft_status status, const NotedVoxels& read)
{
    if (status == CLEFT_ERROR_FORMAT || (status == CLEFT_ERROR_FILE && read.have_failed()))
        return cleft_cli::EXIT_CANNOT_READ;
    return status == CLEFT_ERROR_FILE ? cleft_cli::EXIT_CANNOT_WRITE : cleft_cli::EXIT_MESHING_FAILED;
}

Part make_part(const Session& session, const PartsArguments& arguments, const cleft_voxels& voxels,
               const cleft_options* options, const CountedExchange& counted)
{
    cleft_exchange exchange = counted.exchange();
    const std::string scratch = arguments.scratch_folder();
    exchange.scratch = scratch.empty() ? nullptr : scratch.c_str();
    cleft_part* made = nullptr;
    NotedVoxels noted(voxels);
    const cleft_status status =
        cleft_part_create(session.context(), noted.voxels(), options, &exchange, arguments.ghosts ? 1 : 0, &made);
    Part part(made);
    if (status == CLEFT_ERROR_OUT_OF_MEMORY && !arguments.memory.empty())
        throw Failure(cleft_cli::EXIT_OUT_OF_MEMORY, status,
                      std::string(cleft_context_last_error(session.context())) + "; --memory is " + arguments.memory +
                          ": more ranks, more memory or another --block help");
    session.check(status, exit_code_of(status, noted));
    return part;
}

// Of the whole mesh.
cleft_quality measured(const Ranks& ranks, Session& session, const cleft_part* part)
{
    cleft_quality quality{};
    quality.struct_size = sizeof quality;
    ranks.together([&] {
        session.timed("report", "looking at the mesh", [&] {
            session.check(cleft_mpi_quality(session.context(), MPI_COMM_WORLD, part, &quality),
                          cleft_cli::EXIT_MESHING_FAILED);
        });
    });
    return quality;
}

// What each rank reports, if anybody asks.
std::vector<std::string> reports_of_ranks(const Ranks& ranks, const Session& session, const PartsArguments& arguments,
                                          const cleft_part* part, const std::vector<Sent>& sent)
{
    if (arguments.run.json.empty())
        return {};
    std::string own;
    ranks.together([&] { own = rank_report(session, part, sent); });
    return ranks.gather(own);
}

// What the mesh is made from.
struct Given {
    cleft_cli::Options options;
    std::unique_ptr<Session> session;
    Voxels voxels;
};

Given look_at_arguments(const Ranks& ranks, const PartsArguments& arguments)
{
    Given given;
    ranks.together([&] {
        given.options = arguments.options.make();
        if (!arguments.memory.empty())
            hold_memory_within(bytes_of_size(arguments.memory));
        if (ranks.is_first())
            arguments.check_outputs(ranks.count());
        cleft_cli::RunArguments run = arguments.run;
        run.quiet = run.quiet || !ranks.is_first();
        given.session =
            std::make_unique<Session>(run, std::vector<cleft_cli::Part>{{"mesh", 90}, {"report", 2}, {"write", 8}});
        given.voxels = open_voxels(*given.session, arguments);
        choose_block(ranks, *given.session, arguments, *given.voxels, given.options.get());
        if (ranks.is_first())
            warn_of_old_pieces(ranks, *given.session, arguments);
    });
    return given;
}

void make_and_write(const Ranks& ranks, const PartsArguments& arguments)
{
    const Given given = look_at_arguments(ranks, arguments);
    Session& session = *given.session;
    std::unique_ptr<CountedExchange> exchange;
    Part part;
    // A step of its own: a rank that fails here may not leave the others waiting for its share of the mesh.
    ranks.together([&] { exchange = std::make_unique<CountedExchange>(session); });
    ranks.together([&] {
        session.timed("mesh", "meshing",
                      [&] { part = make_part(session, arguments, *given.voxels, given.options.get(), *exchange); });
    });
    // Also if this rank tells nobody: others may.
    const cleft_quality quality = measured(ranks, session, part.get());
    const std::vector<std::string> reports = reports_of_ranks(ranks, session, arguments, part.get(), exchange->sent());
    cleft_cli::StagedOutputs staged;
    write_outputs(ranks, session, arguments, part.get(), staged);
    session.clear_progress();
    ranks.together([&] {
        if (!ranks.is_first())
            return;
        if (!arguments.run.json.empty())
            cleft_cli::write_json(
                parts_report(session, arguments, given.options.get(), *given.voxels, part.get(), quality, reports),
                arguments.run.json, staged);
        if (arguments.run.prints())
            cleft_cli::print_summary_text(summary(session, arguments, part.get(), quality));
        // Last of all: whatever fails before leaves no output and no part of one.
        staged.commit();
    });
}

int run_parts(const Ranks& ranks, const PartsArguments& arguments)
{
    try {
        make_and_write(ranks, arguments);
        return cleft_cli::EXIT_OK;
    } catch (const Failure& failure) {
        return ranks.is_first() ? cleft_cli::tell_failure("mesh", arguments.run, failure) : failure.exit_code;
    }
}

}  // namespace

std::function<int(const Ranks& ranks)> add_parts_command(CLI::App& app)
{
    auto arguments = std::make_shared<PartsArguments>();
    CLI::App& parser = *app.add_subcommand("mesh", "Make a mesh of a volume on several processes");
    arguments->add_to(parser);
    return [arguments](const Ranks& ranks) { return run_parts(ranks, *arguments); };
}

}  // namespace cleft_mpi_cli
