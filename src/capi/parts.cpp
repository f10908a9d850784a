// Meshes in parts: the entries that several ranks call together.
#include "cleft/cleft_parts.h"

#include "base/stage.hpp"
#include "blocks/rank_mesh.hpp"
#include "capi/firewall.hpp"
#include "capi/kept_labels.hpp"
#include "capi/made_volume.hpp"
#include "capi/mesh_frame.hpp"
#include "capi/options.hpp"
#include "capi/report_rows.hpp"
#include "capi/voxel_type.hpp"
#include "parts/mesh_part.hpp"
#include "parts/part_quality.hpp"
#include "parts/part_ranks.hpp"
#include "parts/repeated_places.hpp"
#include "parts/voxel_source.hpp"

#include <cstring>

template <>
inline constexpr size_t cleft::kFirstSize<cleft_exchange> = CLEFT_END_OF(cleft_exchange, bytes);
template <>
inline constexpr size_t cleft::kFirstSize<cleft_voxels> = CLEFT_END_OF(cleft_voxels, read);
template <>
inline constexpr size_t cleft::kFirstSize<cleft_part_counts> = CLEFT_END_OF(cleft_part_counts, all_triangles);

using namespace cleft::capi;
using cleft::Array;
using cleft::Error;
using cleft::Exchange;
using cleft::Run;

namespace
{

cleft::Messenger messenger(const cleft_exchange& e)
{
    if (e.ranks < 1 || e.rank < 0 || e.rank >= e.ranks)
        throw Error(CLEFT_ERROR_ARGUMENT, "the exchange has rank " + std::to_string(e.rank) + " of " +
                                              std::to_string(e.ranks) + " ranks; ranks count from 0");
    required(reinterpret_cast<const void*>(e.numbers), "numbers of the exchange");
    required(reinterpret_cast<const void*>(e.bytes), "bytes of the exchange");
    return {e.rank, e.ranks, e.scratch ? e.scratch : "",
            [e](const int64_t* send, int64_t* receive) { return e.numbers(send, receive, e.user) == 0; },
            [e](const void* send, const int64_t* send_sizes, void* receive, const int64_t* receive_sizes) {
                return e.bytes(send, send_sizes, receive, receive_sizes, e.user) == 0;
            }};
}

cleft::VoxelSource source_of(const cleft_voxels& v)
{
    required(reinterpret_cast<const void*>(v.read), "read of the voxels");
    return {voxel_type(v.type), [v](const cleft::Window& window, void* voxels) {
                int64_t first[3], count[3];
                std::copy(window.first.begin(), window.first.end(), first);
                std::copy(window.count.begin(), window.count.end(), count);
                char sentence[1000] = "";
                if (v.read(first, count, voxels, sentence, sizeof sentence, v.user) == 0)
                    return;
                sentence[sizeof sentence - 1] = '\0';
                throw Error(CLEFT_ERROR_FILE, sentence[0] ? sentence : "the voxels cannot be read");
            }};
}

// Of what all ranks must give alike. A rank with other options would make another mesh, or wait for ever.
uint64_t fingerprint(const cleft_voxels& voxels, const cleft_options* options, int32_t ghosts)
{
    // FNV-1a, 64 bits.
    uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&](const void* bytes, size_t count) {
        for (size_t i = 0; i < count; ++i)
            hash = (hash ^ static_cast<const unsigned char*>(bytes)[i]) * 0x100000001b3u;
    };
    add(&voxels.type, sizeof voxels.type);
    add(voxels.dims, sizeof voxels.dims);
    add(voxels.affine, sizeof voxels.affine);
    add(&ghosts, sizeof ghosts);
    if (options) {
        add(options->values.data(), sizeof options->values);
        add(options->strip.data(), options->strip.size() * sizeof(cleft::UserLabel));
        add(options->only.data(), options->only.size() * sizeof(cleft::UserLabel));
        for (const auto& [label, size] : options->label_sizes) {
            add(&label, sizeof label);
            add(&size, sizeof size);
        }
    }
    return hash;
}

void require_alike(uint64_t own, Exchange& exchange)
{
    for (const uint64_t other : exchange.all_gather(Array<uint64_t>{own}))
        if (other != own)
            throw Error(CLEFT_ERROR_ARGUMENT, "the ranks do not give the same volume, options and ghosts");
}

// What a rank makes of the mesh, and what the whole volume has.
struct Made {
    cleft::MeshPieces pieces;
    cleft::LabelCounts labels;
};

// The mesh of the whole volume.
Made whole_mesh(const cleft::Frame& frame, const cleft::VoxelSource& source, const cleft_options* options,
                const Run& run)
{
    const Array<unsigned char> voxels = read_window(source, {{0, 0, 0}, frame.grid.dims});
    const int kernel = static_cast<int>(option_value(options, CLEFT_OPTION_SMOOTH));
    const cleft_volume volume =
        made_volume(frame, cleft::Volume::from_labels(source.type, voxels.data(), frame.grid, kernel, run));
    const cleft::PipelineOptions p = pipeline_options(options, volume);
    warn_of_unknown_labels(volume.volume.labels(), options, "volume", run);
    warn_of_unknown_sizes(volume.volume.labels(), options, run);
    return {cleft::MeshPieces::of(mesh_from_volume(volume.volume, p, run)), volume.volume.label_counts()};
}

// The blocks of this rank.
Made mesh_of_own_blocks(const cleft::SharedVoxels& voxels, const cleft::Frame& frame, const cleft_options* options,
                        Exchange& exchange, const Run& run)
{
    const auto block = static_cast<int32_t>(option_value(options, CLEFT_OPTION_BLOCK));
    const int kernel = static_cast<int>(option_value(options, CLEFT_OPTION_SMOOTH));
    cleft::LabelCounts labels = labels_of_all(voxels, block, exchange, run);
    const cleft::PipelineOptions p = pipeline_options(options, frame, labels.labels);
    if (exchange.rank() == 0) {
        warn_of_unknown_labels(labels.labels, options, "volume", run);
        warn_of_unknown_sizes(labels.labels, options, run);
    }
    cleft::MeshPieces pieces = mesh_of_rank(voxels, labels, kernel, p, exchange, run);
    return {std::move(pieces), std::move(labels)};
}

// What a rank makes of the mesh, before it is shared out.
Made made_by_rank(const cleft::SharedVoxels& voxels, const cleft::Frame& frame, const cleft_options* options,
                  Exchange& exchange, const Run& run)
{
    const cleft::PipelineOptions p = pipeline_options(options);
    const std::string reason = needs_whole_mesh(p, voxels.grid);
    if (reason.empty())
        return mesh_of_own_blocks(voxels, frame, options, exchange, run);
    if (!fits_in_one_piece(voxels.grid))
        throw Error(
            CLEFT_ERROR_TOO_LARGE,
            "the volume has more than 2147483647 voxels, too many to mesh in one piece, which is needed since " +
                reason);
    Made made;
    if (exchange.rank() == 0) {
        if (exchange.ranks() > 1)
            run.warn("the first rank makes the whole mesh alone, since " + reason);
        made = whole_mesh(frame, voxels.source, options, run);
    }
    made.labels = {exchange.all_gather(made.labels.labels), exchange.all_gather(made.labels.voxels)};
    return made;
}

// What each label has in the mesh and in the volume, in the world.
Array<cleft::PartLabel> labels_in_world(const cleft::LabelCounts& labels, const cleft::Frame& frame,
                                        const cleft_options* options, const cleft::MeshPart& part, Exchange& exchange)
{
    auto rows = part_labels(labels, kept_labels(labels.labels, options, "volume"), frame.grid, part, exchange);
    for (cleft::PartLabel& row : rows) {
        row.voxel_volume = frame.volume(row.voxel_volume);
        row.mesh_volume = frame.volume(row.mesh_volume);
    }
    return rows;
}

// What to_user() does for a whole mesh.
void to_user(const cleft::Frame& frame, cleft::MeshPart& part, Exchange& exchange, const Run& run)
{
    part.points = to_world(part.points, part.tets, frame, run);
    // Those of one part were looked at, and in the frame of the voxels no two points have one place.
    if (exchange.ranks() > 1 && has_repeated_places(part.points, part.of_points.owned, exchange))
        refuse_coarse_world("points of two parts are at one place");
    if (frame.flips())
        for (cleft::PartTriangle& t : part.triangles)
            std::swap(t.corners[1], t.corners[2]);
}

cleft_part made_part(cleft::MeshPart&& part, Array<cleft::PartLabel>&& labels, const Exchange& exchange)
{
    cleft_part out;
    out.counts = {sizeof out.counts,       exchange.rank(),      exchange.ranks(),   part.points.count(),
                  part.of_points.owned,    part.of_points.first, part.of_points.all, part.tets.count(),
                  part.of_tets.owned,      part.of_tets.first,   part.of_tets.all,   part.triangles.count(),
                  part.of_triangles.first, part.of_triangles.all};
    for (const cleft::PartTriangle& t : part.triangles) {
        out.triangles.push_back(t.corners);
        out.triangle_labels.push_back(t.regions);
        out.triangle_sides.push_back(t.side);
    }
    part.triangles = Array<cleft::PartTriangle>();
    out.part = std::move(part);
    out.labels = std::move(labels);
    return out;
}

cleft_part part_of(const cleft_voxels* given, const cleft_options* options, bool ghosts, Exchange& exchange,
                   const Run& run)
{
    const auto held_options = held_if_any(options, "options");
    const cleft_voxels voxels = cleft::copy_in(*required(given, "voxels"), "cleft_voxels");
    require_alike(fingerprint(voxels, options, ghosts), exchange);
    const cleft::Frame frame = cleft::make_frame_of_parts(voxels.dims, voxels.affine);
    const cleft::VoxelSource source = source_of(voxels);
    cleft::Steps steps(run, {{"mesh", 9}, {nullptr, 1}});
    const Run of_mesh = steps.next();
    const Made made = made_by_rank({frame.grid, source}, frame, options, exchange, of_mesh);
    const cleft::BoundingBox box{cleft::Vec3::Zero(), frame.grid.extent()};
    cleft::MeshPart part = share_mesh(made.pieces, made.labels.labels, box, ghosts, exchange, steps.next());
    auto labels = labels_in_world(made.labels, frame, options, part, exchange);
    to_user(frame, part, exchange, run);
    return made_part(std::move(part), std::move(labels), exchange);
}

template <class T, class Get>
const T* borrowed(const cleft_part* part, const Get& get)
{
    return is_sound(part) && !get(*part).empty() ? reinterpret_cast<const T*>(get(*part).data()) : nullptr;
}

}  // namespace

cleft_status cleft_part_create(cleft_context* context, const cleft_voxels* voxels, const cleft_options* options,
                               const cleft_exchange* exchange, int32_t ghosts, cleft_part** out) noexcept
{
    if (out)
        *out = nullptr;
    return guarded_run(context, "mesh", [&](const Run& run) {
        const cleft_exchange of_ranks = cleft::copy_in(*required(exchange, "exchange"), "cleft_exchange");
        Exchange messages(messenger(of_ranks));
        std::unique_ptr<cleft_part> made;
        // All but the exchange is looked at in here: of a mistake of one rank, all hear. The last report may cancel.
        messages.together([&] {
            required(out, "out");
            made = std::make_unique<cleft_part>(part_of(voxels, options, ghosts != 0, messages, run));
            run.report(1);
        });
        *out = made.release();
    });
}

void cleft_part_destroy(cleft_part* part) noexcept { destroy(part); }

cleft_status cleft_part_count(const cleft_part* part, cleft_part_counts* out) noexcept
{
    return guarded(nullptr, [&] {
        cleft::check_struct_size(*required(out, "out"), "cleft_part_counts");
        cleft::copy_out(checked(part, "part").counts, *out);
    });
}

cleft_status cleft_part_quality(cleft_context* context, const cleft_part* part, const cleft_exchange* exchange,
                                cleft_quality* out) noexcept
{
    return guarded_run(context, "quality", [&](const Run& run) {
        const cleft_exchange of_ranks = cleft::copy_in(*required(exchange, "exchange"), "cleft_exchange");
        Exchange messages(messenger(of_ranks));
        cleft::Quality quality;
        messages.together([&] {
            const auto from = held(part, "part");
            check_ranks_of_part(from->counts.rank, from->counts.ranks, messages);
            cleft::check_struct_size(*required(out, "out"), "cleft_quality");
            quality = part_quality(from->part, messages, run);
            run.report(1);
        });
        cleft::copy_out(row_of(quality), *out);
    });
}

cleft_status cleft_part_own_quality(cleft_context* context, const cleft_part* part, cleft_quality* out) noexcept
{
    return guarded_run(context, "quality", [&](const Run& run) {
        const auto from = held(part, "part");
        cleft::check_struct_size(*required(out, "out"), "cleft_quality");
        const cleft::Quality quality = own_quality(from->part, run);
        run.report(1);
        cleft::copy_out(row_of(quality), *out);
    });
}

int64_t cleft_part_label_count(const cleft_part* part) noexcept { return is_sound(part) ? part->labels.count() : 0; }

cleft_status cleft_part_label(const cleft_part* part, int64_t index, cleft_label_report* out) noexcept
{
    return guarded(nullptr, [&] {
        cleft::check_struct_size(*required(out, "out"), "cleft_label_report");
        if (index < 0 || index >= checked(part, "part").labels.count())
            throw Error(CLEFT_ERROR_ARGUMENT, "there is no such label");
        cleft::copy_out(row_of(part->labels[index]), *out);
    });
}

const double* cleft_part_points(const cleft_part* part) noexcept
{
    return borrowed<double>(
        part, [](const cleft_part& p) -> auto& { return p.part.points; });
}

const int64_t* cleft_part_point_numbers(const cleft_part* part) noexcept
{
    return borrowed<int64_t>(
        part, [](const cleft_part& p) -> auto& { return p.part.numbers; });
}

const int32_t* cleft_part_point_owners(const cleft_part* part) noexcept
{
    return borrowed<int32_t>(
        part, [](const cleft_part& p) -> auto& { return p.part.owners; });
}

const int32_t* cleft_part_tets(const cleft_part* part) noexcept
{
    return borrowed<int32_t>(
        part, [](const cleft_part& p) -> auto& { return p.part.tets; });
}

const int32_t* cleft_part_tet_labels(const cleft_part* part) noexcept
{
    return borrowed<int32_t>(
        part, [](const cleft_part& p) -> auto& { return p.part.material; });
}

const int64_t* cleft_part_tet_numbers(const cleft_part* part) noexcept
{
    return borrowed<int64_t>(
        part, [](const cleft_part& p) -> auto& { return p.part.tet_numbers; });
}

const int32_t* cleft_part_tet_owners(const cleft_part* part) noexcept
{
    return borrowed<int32_t>(
        part, [](const cleft_part& p) -> auto& { return p.part.tet_owners; });
}

const int32_t* cleft_part_triangles(const cleft_part* part) noexcept
{
    return borrowed<int32_t>(
        part, [](const cleft_part& p) -> auto& { return p.triangles; });
}

const int32_t* cleft_part_triangle_labels(const cleft_part* part) noexcept
{
    return borrowed<int32_t>(
        part, [](const cleft_part& p) -> auto& { return p.triangle_labels; });
}

const int32_t* cleft_part_triangle_sides(const cleft_part* part) noexcept
{
    return borrowed<int32_t>(
        part, [](const cleft_part& p) -> auto& { return p.triangle_sides; });
}
