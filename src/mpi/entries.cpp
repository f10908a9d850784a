// The functions of cleft_mpi.h that need the ranks of a communicator.
#include "base/status_of.hpp"
#include "base/struct_size.hpp"
#include "cleft/cleft_mpi.h"
#include "io/entry.hpp"
#include "io/file_name.hpp"
#include "mpi/mpi_exchange.hpp"
#include "mpi/part_writers.hpp"
#include "parts/part_ranks.hpp"

#include <memory>

template <>
inline constexpr size_t cleft::kFirstSize<cleft_exchange> = CLEFT_END_OF(cleft_exchange, bytes);

namespace cleft::mpi
{

namespace
{

// The functions of cleft_exchange. No exception passes them.
template <class Send>
int result_of(void* user, const Send& send) noexcept
{
    try {
        return send(*static_cast<MpiExchange*>(user)) ? 0 : 1;
    } catch (...) {
        return 1;
    }
}

int exchange_numbers(const int64_t* send, int64_t* receive, void* user)
{
    return result_of(user, [&](MpiExchange& mpi) { return mpi.numbers(send, receive); });
}

int exchange_bytes(const void* send, const int64_t* send_sizes, void* receive, const int64_t* receive_sizes, void* user)
{
    return result_of(user, [&](MpiExchange& mpi) { return mpi.bytes(send, send_sizes, receive, receive_sizes); });
}

cleft_exchange described(MpiExchange& mpi)
{
    return {sizeof(cleft_exchange), mpi.rank(), mpi.ranks(), &mpi, exchange_numbers, exchange_bytes, nullptr};
}

PartView view_of(const cleft_part* part, const Exchange& exchange, cleft_context* context)
{
    PartView view{};
    view.counts.struct_size = sizeof view.counts;
    io::check(context, cleft_part_count(part, &view.counts), "the part: ");
    check_ranks_of_part(view.counts.rank, view.counts.ranks, exchange);
    view.points = cleft_part_points(part);
    view.numbers = cleft_part_point_numbers(part);
    view.owners = cleft_part_point_owners(part);
    view.tets = cleft_part_tets(part);
    view.labels = cleft_part_tet_labels(part);
    view.triangles = cleft_part_triangles(part);
    view.triangle_labels = cleft_part_triangle_labels(part);
    view.sides = cleft_part_triangle_sides(part);
    return view;
}

using Writer = std::vector<std::string> (*)(const PartView&, const Writing&);

Writer writer_of(const std::string& path)
{
    const std::string extension = io::extension_of(path);
    if (extension == ".pvtu")
        return write_pvtu;
    if (extension == ".vtkhdf" || extension == ".hdf")
        return write_vtkhdf;
    if (extension == ".mfem")
        return write_mfem;
    throw Error(
        CLEFT_ERROR_UNSUPPORTED,
        "'" + path + "': meshes in parts are written as .vtkhdf, .hdf, .pvtu or .mfem, by the extension of the path");
}

// Files that all ranks write, until they have their names.
class SharedOutputs
{
public:
    SharedOutputs(const PartView& part, Exchange& exchange, cleft_context* context)
        : part_(part), exchange_(exchange), context_(context)
    {
    }

    // The path of rank 0 counts, and so does its writer, as all have the name from there.
    void write(const std::string& path, double from, double to)
    {
        stages_.push_back(std::make_unique<SharedStage>());
        SharedStage& stage = *stages_.back();
        stage.open(path, exchange_);
        const auto report = [&](double fraction) {
            const double done = from + (to - from) * fraction;
            io::check(context_, cleft_context_report(context_, done, done, "writing"));
        };
        try {
            written_.push_back({stage, writer_of(stage.name())(part_, {stage, exchange_, report})});
        } catch (const Error& error) {
            throw Error(error.status(), stage.with_final_names(error.what()));
        }
    }

    void commit()
    {
        // All ranks have written.
        exchange_.all_gather(int64_t{0});
        if (exchange_.rank() == 0)
            cleft::mpi::commit(written_);
    }

private:
    const PartView& part_;
    Exchange& exchange_;
    cleft_context* context_;
    std::vector<std::unique_ptr<SharedStage>> stages_;
    std::vector<StagedFiles> written_;
};

// Of rank 0; others need none. What is wrong with one is found before any is written.
std::vector<std::string> checked_paths(const char* const* paths, int64_t count, const Exchange& exchange)
{
    std::vector<std::string> out;
    if (exchange.rank() > 0)
        return out;
    if (count < 1)
        throw Error(CLEFT_ERROR_ARGUMENT, "count is " + std::to_string(count) + "; it must be at least 1");
    io::required(paths, "paths");
    for (int64_t i = 0; i < count; ++i) {
        out.emplace_back(io::required(paths[i], "path"));
        writer_of(out.back());
    }
    return out;
}

void write_all(SharedOutputs& outputs, const char* const* paths, int64_t count, Exchange& exchange)
{
    const std::vector<std::string> mine = checked_paths(paths, count, exchange);
    const int64_t all = exchange.all_gather(static_cast<int64_t>(mine.size()))[0];
    for (int64_t i = 0; i < all; ++i)
        outputs.write(mine.empty() ? "" : mine[to_size(i)], double(i) / double(all), double(i + 1) / double(all));
    outputs.commit();
}

}  // namespace

}  // namespace cleft::mpi

using cleft::Exchange;
using cleft::mpi::MpiExchange;

cleft_status cleft_mpi_exchange_open(MPI_Comm comm, cleft_exchange* out) noexcept
{
    return cleft::io::guarded(nullptr, [&] {
        cleft::check_struct_size(*cleft::io::required(out, "out"), "cleft_exchange");
        auto mpi = std::make_unique<MpiExchange>(comm);
        cleft::copy_out(cleft::mpi::described(*mpi), *out);
        (void)mpi.release();  // owned by *out
    });
}

void cleft_mpi_exchange_close(cleft_exchange* exchange) noexcept
{
    if (!exchange || exchange->numbers != cleft::mpi::exchange_numbers)
        return;
    delete static_cast<MpiExchange*>(exchange->user);
    exchange->user = nullptr;
    exchange->numbers = nullptr;
    exchange->bytes = nullptr;
}

cleft_status cleft_mpi_mesh(cleft_context* context, MPI_Comm comm, const cleft_voxels* voxels,
                            const cleft_options* options, int32_t ghosts, cleft_part** out) noexcept
{
    return cleft::io::entry_making(context, out, {options}, [&] {
        MpiExchange mpi(comm);
        const cleft_exchange exchange = cleft::mpi::described(mpi);
        cleft_part* part = nullptr;
        cleft::io::check(context, cleft_part_create(context, voxels, options, &exchange, ghosts, &part));
        *out = part;
    });
}

cleft_status cleft_mpi_quality(cleft_context* context, MPI_Comm comm, const cleft_part* part,
                               cleft_quality* out) noexcept
{
    return cleft::io::entry(context, {part}, [&] {
        MpiExchange mpi(comm);
        const cleft_exchange exchange = cleft::mpi::described(mpi);
        cleft::io::check(context, cleft_part_quality(context, part, &exchange, out));
    });
}

cleft_status cleft_mpi_write(cleft_context* context, MPI_Comm comm, const cleft_part* part, const char* path) noexcept
{
    return cleft_mpi_write_all(context, comm, part, &path, 1);
}

cleft_status cleft_mpi_write_all(cleft_context* context, MPI_Comm comm, const cleft_part* part,
                                 const char* const* paths, int64_t count) noexcept
{
    return cleft::io::entry(context, {part}, [&] {
        MpiExchange mpi(comm);
        Exchange exchange(mpi.messenger());
        // Stages go when all ranks have ended their work in them.
        std::unique_ptr<cleft::mpi::SharedOutputs> outputs;
        cleft::mpi::PartView view{};
        exchange.together([&] {
            view = cleft::mpi::view_of(cleft::io::required(part, "part"), exchange, context);
            outputs = std::make_unique<cleft::mpi::SharedOutputs>(view, exchange, context);
            cleft::mpi::write_all(*outputs, paths, count, exchange);
        });
    });
}
