// Cuts parts out, has the stages work on them, and puts them back.
#include "pipeline/block_job.hpp"

#include "base/stage.hpp"
#include "cleaving/mend.hpp"
#include "mesh/materials.hpp"
#include "mesh/piece.hpp"
#include "pipeline/quiet_run.hpp"
#include "pipeline/volumes_inside.hpp"

#include <utility>

namespace cleft
{

namespace
{

// Rings of tetrahedra around the points of a seam that its work is about. A search changes some three rings around a
// bad tetrahedron.
constexpr int kSeamRings = 6;

BoundingBox box_of(const Volume& volume) { return {Vec3::Zero(), volume.grid().extent()}; }

LabelledMesh worked_on(const Volume& volume, const Cleaved& cleaved, Array<double> volumes,
                       const PipelineOptions& options, const Run& run)
{
    const Region region{box_of(volume), std::move(volumes)};
    PipelineOptions of_part = options;
    of_part.region = &region;
    return improve_and_fit(volume, cleaved, of_part, run);
}

LabelledMesh copy_of(const LabelledMesh& mesh)
{
    return piece_of(mesh, [](int64_t) { return true; });
}

}  // namespace

Block block_of(TetMesh background, const BoundingBox& box, const Run& run)
{
    Block block;
    block.background = std::move(background);
    block.held = points_of_cut(block.background, box, quiet(run));
    return block;
}

void snap_block(const Volume& volume, Block& block, const PipelineOptions& options, const Run& run)
{
    if (block.background.tets.empty())
        return;
    CleaveOptions snapping = options.cleave;
    snapping.held = Array<int32_t>(block.held.begin(), block.held.end());
    block.snapped = snap_background(volume, block.background, snapping, {}, quiet(run));
}

void mesh_block(const Volume& volume, Block& block, const PipelineOptions& options, const Run& run)
{
    if (block.background.tets.empty())
        return;
    const Run of_part = quiet(run);
    CleaveOptions cutting = options.cleave;
    cutting.held = Array<int32_t>(block.held.begin(), block.held.end());
    const auto cut = [&](const Run& part) {
        return cleave_snapped(volume, block.background, cutting, block.snapped, part);
    };
    LabelledMesh first = cut(of_part);
    Array<double> volumes = volumes_inside(volume, first, of_part);
    // Improving asks for it again only where it tries again.
    const Cleaved cleaved = [&](const Run& part) {
        return first.tets.empty() ? cut(part) : std::exchange(first, LabelledMesh());
    };
    block.mesh = worked_on(volume, cleaved, std::move(volumes), options, of_part);
}

void improve_seam(const Volume& volume, LabelledMesh& lower, LabelledMesh& upper, const IsAbove& is_above,
                  const PipelineOptions& options, const Run& run)
{
    if (lower.tets.empty() || upper.tets.empty())
        return;
    const Run of_part = quiet(run);
    const BoundingBox box = box_of(volume);
    const Array<int32_t> cut_of_lower = points_of_cut(lower, box, of_part),
                         cut_of_upper = points_of_cut(upper, box, of_part);
    const auto near_in_lower =
        near_points(lower.tets, lower.points.size(),
                    shared_points(lower.points, cut_of_lower, upper.points, cut_of_upper), kSeamRings);
    const auto near_in_upper =
        near_points(upper.tets, upper.points.size(),
                    shared_points(upper.points, cut_of_upper, lower.points, cut_of_lower), kSeamRings);
    LabelledMesh low = piece_of(lower, [&](int64_t t) { return near_in_lower[t] != 0; });
    const LabelledMesh high = piece_of(upper, [&](int64_t t) { return near_in_upper[t] != 0; });
    const Array<int32_t> on_seam =
        shared_points(low.points, points_of_cut(low, box, of_part), high.points, points_of_cut(high, box, of_part));
    LabelledMesh seam = joined(std::move(low), high, of_part);  // the points of `low` keep their numbers
    mend_interfaces(seam, on_seam, of_part);
    lower = piece_of(lower, [&](int64_t t) { return near_in_lower[t] == 0; });
    upper = piece_of(upper, [&](int64_t t) { return near_in_upper[t] == 0; });
    const Cleaved as_it_is = [&](const Run&) { return copy_of(seam); };
    // Together the blocks have the volumes that they are to have. Where they meet, labels keep those of both.
    const LabelledMesh better = worked_on(
        volume, as_it_is, material_volumes(seam.points, seam.tets, seam.material, volume.material_count(), of_part),
        options, of_part);
    const auto above = [&](int64_t t) { return is_above(better.points, better.tets[t]); };
    lower = joined(std::move(lower), piece_of(better, [&](int64_t t) { return !above(t); }), of_part);
    upper = joined(std::move(upper), piece_of(better, above), of_part);
}

}  // namespace cleft
