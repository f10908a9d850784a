// Cuts parts out, has the stages work on them, and puts them back.
#include "blocks/block_job.hpp"

#include "base/quiet_run.hpp"
#include "base/stage.hpp"
#include "blocks/volumes_inside.hpp"
#include "cleaving/mend.hpp"
#include "mesh/materials.hpp"
#include "mesh/piece.hpp"

namespace cleft
{

namespace
{

// Rings of tetrahedra around the points of a seam that its work is about. A search changes some three rings around a
// bad tetrahedron.
constexpr int kSeamRings = 6;

BoundingBox box_of(const Volume& volume) { return {Vec3::Zero(), volume.grid().extent()}; }

LabelledMesh worked_on(const Volume& volume, const Cleaved& cleaved, const Region& region,
                       const PipelineOptions& options, const Run& run)
{
    PipelineOptions of_part = options;
    of_part.region = &region;
    return improve_and_fit(volume, cleaved, of_part, run);
}

LabelledMesh copy_of(const LabelledMesh& mesh)
{
    return piece_of(mesh, [](int64_t) { return true; });
}

CleaveOptions cleaving_of(const Block& block, const PipelineOptions& options)
{
    CleaveOptions cleaving = options.cleave;
    cleaving.held = Array<int32_t>(block.held.begin(), block.held.end());
    return cleaving;
}

}  // namespace

Block block_of(const TetMesh& background, const BoundingBox& box, const Run& run)
{
    Block block;
    block.background = ordered_by_place(background);
    block.held = points_of_cut(block.background, box, quiet(run));
    return block;
}

void snap_block(const VolumeParts& volume, Block& block, const PipelineOptions& options, const Run& run)
{
    if (block.background.tets.empty())
        return;
    const auto around = volume.around(block.background.points, block.background.tets);
    block.snapped = snap_background(*around, block.background, cleaving_of(block, options), {}, quiet(run));
}

void mesh_block(const VolumeParts& volume, Block& block, const PipelineOptions& options, const Run& run)
{
    if (block.background.tets.empty())
        return;
    const auto around = volume.around(block.background.points, block.background.tets);
    const Run of_part = quiet(run);
    const CleaveOptions cutting = cleaving_of(block, options);
    const auto cut = [&](const Run& part) {
        return cleave_snapped(*around, block.background, cutting, block.snapped, part);
    };
    LabelledMesh first = cut(of_part);
    const Region region{box_of(*around), volumes_inside(*around, first, of_part), true};
    // Improving asks for it again only where it tries again.
    const Cleaved cleaved = [&](const Run& part) {
        return first.tets.empty() ? cut(part) : std::exchange(first, LabelledMesh());
    };
    block.mesh = worked_on(*around, cleaved, region, options, of_part);
}

Array<Vec3> places_of_cut(const Block& block) { return places_of(block.background.points, block.held); }

Array<Vec3> places_of_cut(const LabelledMesh& mesh, const BoundingBox& box, const Run& run)
{
    return places_of(mesh.points, points_of_cut(mesh, box, quiet(run)));
}

LabelledMesh taken_near(LabelledMesh& mesh, const Array<Vec3>& places_of_other, const BoundingBox& box, const Run& run)
{
    const Array<int32_t> on_seam = points_at(mesh.points, points_of_cut(mesh, box, quiet(run)), places_of_other);
    const Array<uint8_t> is_near = near_points(mesh.tets, mesh.points.size(), on_seam, kSeamRings);
    LabelledMesh taken = piece_of(mesh, [&](int64_t t) { return is_near[t] != 0; });
    mesh = piece_of(mesh, [&](int64_t t) { return is_near[t] == 0; });
    return taken;
}

std::pair<LabelledMesh, LabelledMesh> improve_seam(const VolumeParts& volume, LabelledMesh lower,
                                                   const LabelledMesh& upper, double seam,
                                                   const PipelineOptions& options, const Run& run)
{
    if (lower.tets.empty() || upper.tets.empty())
        return {std::move(lower), copy_of(upper)};
    const Run of_part = quiet(run);
    const BoundingBox box{Vec3::Zero(), volume.grid.extent()};
    const Array<int32_t> on_seam =
        points_at(lower.points, points_of_cut(lower, box, of_part), places_of_cut(upper, box, of_part));
    LabelledMesh both = joined(std::move(lower), upper, of_part);  // the points of `lower` keep their numbers
    mend_interfaces(both, on_seam, of_part);
    const auto around = volume.around(both.points, both.tets);
    const Cleaved as_it_is = [&](const Run&) { return copy_of(both); };
    // Together the blocks have the volumes that they are to have. Where they meet, labels keep those of both.
    const Region region{box, material_volumes(both.points, both.tets, both.material, around->material_count(), of_part),
                        false};
    const LabelledMesh better = worked_on(*around, as_it_is, region, options, of_part);
    const auto is_above = [&](int64_t t) { return middle_of(better.points, better.tets[t]) >= seam; };
    return {piece_of(better, [&](int64_t t) { return !is_above(t); }), piece_of(better, is_above)};
}

}  // namespace cleft
