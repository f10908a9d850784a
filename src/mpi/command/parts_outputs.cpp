// The first rank stages the outputs as the command cleft does, and all write at the places that it says.
#include "mpi/command/parts_outputs.hpp"

#include "cleft/cleft_mpi.h"

namespace cleft_mpi_cli
{
namespace
{

using cleft_cli::Failure;
using cleft_cli::Session;

// Where all ranks write the outputs until they have their names. On the first rank; what that says counts.
std::vector<std::string> places_of(const Ranks& ranks, const PartsArguments& arguments,
                                   cleft_cli::StagedOutputs& staged)
{
    std::vector<std::string> places;
    ranks.together([&] {
        if (!ranks.is_first())
            return;
        for (const std::string& path : arguments.outputs)
            places.push_back(staged.place(PartsArguments::target_of(path)));
    });
    return places;
}

}  // namespace

void warn_of_old_pieces(const Ranks& ranks, Session& session, const PartsArguments& arguments)
{
    for (const std::string& output : arguments.outputs) {
        const std::vector<std::string> pieces = PartsArguments::pieces_of(output, ranks.count() + 1);
        std::error_code ignored;
        if (!pieces.empty() && std::filesystem::exists(pieces.back(), ignored))
            session.warn("'" + pieces.back() + "' is of another run with more ranks: it stays, and is no part of '" +
                         output + "'");
    }
}

void write_outputs(const Ranks& ranks, Session& session, const PartsArguments& arguments, const cleft_part* part,
                   cleft_cli::StagedOutputs& staged)
{
    const std::vector<std::string> places = places_of(ranks, arguments, staged);
    std::vector<const char*> paths;
    paths.reserve(places.size());
    for (const std::string& place : places)
        paths.push_back(place.c_str());
    ranks.together([&] {
        try {
            session.timed("write", "writing", [&] {
                session.check(cleft_mpi_write_all(session.context(), MPI_COMM_WORLD, part, paths.data(),
                                                  static_cast<int64_t>(paths.size())),
                              cleft_cli::EXIT_CANNOT_WRITE);
            });
        } catch (const Failure& failure) {
            throw staged.described(failure);
        }
    });
}

}  // namespace cleft_mpi_cli
