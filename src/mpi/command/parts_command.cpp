// Each step ends with an agreement of all ranks, and one of them prints.
#include "mpi/command/parts_command.hpp"

#include "cleft/cleft_io_parts.h"
#include "cleft/cleft_mpi.h"
#include "cli/guarded.hpp"
#include "cli/json_report.hpp"
#include "cli/staged_outputs.hpp"
#include "cli/standard_output.hpp"
#include "cli/summary.hpp"
#include "cli/text.hpp"
#include "mpi/command/counted_exchange.hpp"
#include "mpi/command/memory_bound.hpp"
#include "mpi/command/parts_arguments.hpp"
#include "mpi/command/parts_report.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace cleft_mpi_cli
{
namespace
{

using cleft_cli::Failure;
using cleft_cli::Session;

struct CloseVoxels {
    void operator()(cleft_voxels* voxels) const
    {
        // Each leaves the other's as it is.
        cleft_mpi_voxels_close(voxels);
        cleft_io_voxels_close(voxels);
        delete voxels;
    }
};
using Voxels = std::unique_ptr<cleft_voxels, CloseVoxels>;

struct DestroyPart {
    void operator()(cleft_part* part) const { cleft_part_destroy(part); }
};
using Part = std::unique_ptr<cleft_part, DestroyPart>;

// The origin stays that of the file.
void set_spacing(cleft_voxels& voxels, const std::vector<double>& spacing)
{
    for (std::size_t axis = 0; axis < spacing.size(); ++axis) {
        double* const step = voxels.affine + axis;
        const double factor = spacing[axis] / std::hypot(step[0], step[4], step[8]);
        for (const int row : {0, 4, 8})
            step[row] *= factor;
    }
}

Voxels open_voxels(const Session& session, const PartsArguments& arguments)
{
    Voxels voxels(new cleft_voxels{});
    voxels->struct_size = sizeof *voxels;
    const char* path = arguments.input().c_str();
    const std::vector<double>& spacing = arguments.volume.spacing;
    if (arguments.is_hdf5()) {
        session.check(cleft_mpi_voxels_open(session.context(), path,
                                            arguments.dataset.empty() ? nullptr : arguments.dataset.c_str(),
                                            spacing.empty() ? nullptr : spacing.data(), voxels.get()),
                      cleft_cli::EXIT_CANNOT_READ);
        return voxels;
    }
    const cleft_io_raw raw = arguments.volume.raw();
    const bool is_raw = !arguments.volume.dims.empty();
    session.check(cleft_io_voxels_open(session.context(), path, is_raw ? &raw : nullptr, voxels.get()),
                  cleft_cli::EXIT_CANNOT_READ);
    if (!is_raw)
        set_spacing(*voxels, spacing);
    return voxels;
}

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

// The voxels as they are read, and whether that has failed: scratch files that cannot be written have the same status.
class NotedVoxels
{
public:
    explicit NotedVoxels(const cleft_voxels& of) : of_(of), noted_(of)
    {
        noted_.read = read;
        noted_.user = this;
    }
    const cleft_voxels* voxels() const { return &noted_; }
    bool have_failed() const { return have_failed_; }

private:
    static int read(const int64_t first[3], const int64_t count[3], void* voxels, char* sentence, int64_t room,
                    void* user)
    {
        auto& self = *static_cast<NotedVoxels*>(user);
        const int failed = self.of_.read(first, count, voxels, sentence, room, self.of_.user);
        self.have_failed_ = self.have_failed_ || failed != 0;
        return failed;
    }

    const cleft_voxels& of_;
    cleft_voxels noted_;
    bool have_failed_ = false;
};

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

// Slabs that ranks share where nobody chose any: they follow from the volume, so that the mesh does. 0: it is too thin.
int64_t block_to_share(int64_t planes)
{
    // Thinner slabs are mostly seams. Who has more ranks than slabs has a reason to choose.
    constexpr int64_t kThinnest = 32, kSlabs = 16;
    return planes < 2 * kThinnest ? 0 : std::max(kThinnest, planes / kSlabs);
}

int64_t integer_of(Session& session, const cleft_options* options, cleft_option key)
{
    int64_t value = 0;
    session.check(cleft_options_get_integer(options, key, &value), cleft_cli::EXIT_USAGE);
    return value;
}

// With these options the first rank makes the whole mesh, whatever the slabs are.
bool is_made_by_one(Session& session, const cleft_options* options)
{
    double anisotropy = 1;
    session.check(cleft_options_get_real(options, CLEFT_OPTION_ANISOTROPY, &anisotropy), cleft_cli::EXIT_USAGE);
    return anisotropy > 1 || integer_of(session, options, CLEFT_OPTION_TETS) > 0 ||
           integer_of(session, options, CLEFT_OPTION_STRICT) != 0;
}

// The first rank says which slabs were chosen, since the mesh depends on them.
void choose_block(const Ranks& ranks, Session& session, const PartsArguments& arguments, const cleft_voxels& voxels,
                  cleft_options* options)
{
    const bool is_bounded = !arguments.memory.empty();
    if (arguments.options.has(CLEFT_OPTION_BLOCK) || is_made_by_one(session, options))
        return;
    const int64_t block = is_bounded ? block_within(bytes_of_size(arguments.memory), arguments.memory, voxels.dims)
                                     : block_to_share(voxels.dims[2]);
    session.check(cleft_options_set_integer(options, CLEFT_OPTION_BLOCK, block), cleft_cli::EXIT_USAGE);
    if (!ranks.is_first() || block == 0)
        return;
    const std::string planes = std::to_string(block);
    session.warn(is_bounded ? "--memory " + arguments.memory + " has the mesh made in slabs of " + planes +
                                  " planes: it is that of --block " + planes
                            : "ranks share slabs of " + planes + " planes: the mesh is that of --block " + planes +
                                  "; --block 0 has the first rank make it as a whole");
}

// Of a run of more ranks, pieces stay that a pattern such as "m_*.vtu" would take for pieces of this mesh.
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

void write_outputs(const Ranks& ranks, Session& session, const PartsArguments& arguments, const cleft_part* part,
                   cleft_cli::StagedOutputs& staged)
{
    const std::vector<std::string> places = places_of(ranks, arguments, staged);
    std::vector<const char*> paths;
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

void make_and_write(const Ranks& ranks, const PartsArguments& arguments)
{
    cleft_cli::Options options;
    std::unique_ptr<Session> session;
    Voxels voxels;
    std::unique_ptr<CountedExchange> exchange;
    Part part;
    ranks.together([&] {
        options = arguments.options.make();
        if (!arguments.memory.empty())
            hold_memory_within(bytes_of_size(arguments.memory));
        if (ranks.is_first())
            arguments.check_outputs(ranks.count());
        cleft_cli::RunArguments run = arguments.run;
        run.quiet = run.quiet || !ranks.is_first();
        session =
            std::make_unique<Session>(run, std::vector<cleft_cli::Part>{{"mesh", 90}, {"report", 2}, {"write", 8}});
        voxels = open_voxels(*session, arguments);
        choose_block(ranks, *session, arguments, *voxels, options.get());
        if (ranks.is_first())
            warn_of_old_pieces(ranks, *session, arguments);
    });
    // A step of its own: a rank that fails here may not leave the others waiting for its share of the mesh.
    ranks.together([&] { exchange = std::make_unique<CountedExchange>(*session); });
    ranks.together([&] {
        session->timed("mesh", "meshing",
                       [&] { part = make_part(*session, arguments, *voxels, options.get(), *exchange); });
    });
    // Also if this rank tells nobody: others may.
    const cleft_quality quality = measured(ranks, *session, part.get());
    const std::vector<std::string> reports = reports_of_ranks(ranks, *session, arguments, part.get(), exchange->sent());
    cleft_cli::StagedOutputs staged;
    write_outputs(ranks, *session, arguments, part.get(), staged);
    session->clear_progress();
    ranks.together([&] {
        if (!ranks.is_first())
            return;
        if (!arguments.run.json.empty())
            cleft_cli::write_json(
                parts_report(*session, arguments, options.get(), *voxels, part.get(), quality, reports),
                arguments.run.json, staged);
        if (arguments.run.prints())
            cleft_cli::print_summary_text(summary(*session, arguments, part.get(), quality));
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
