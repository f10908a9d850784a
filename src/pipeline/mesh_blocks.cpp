// The order of the blocks and of the seams.
#include "pipeline/mesh_blocks.hpp"

#include "base/stage.hpp"
#include "mesh/piece.hpp"
#include "pipeline/block_job.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

double middle_of(const Array<Vec3>& points, const Tet& tet)
{
    return 0.25 * (points[tet[0]][2] + points[tet[1]][2] + points[tet[2]][2] + points[tet[3]][2]);
}

// Seams of even number first, then the others: two of a kind have no block in common.
template <class Work>
void for_each_seam(int32_t blocks, const Work& work)
{
    for (int32_t parity = 0; parity < 2; ++parity)
        for (int32_t b = parity; b + 1 < blocks; b += 2)
            work(b);
}

Array<Block> blocks_of(const TetMesh& background, int32_t count, double thickness, const BoundingBox& box,
                       const Run& run)
{
    const TetMesh ordered = ordered_by_place(background);
    const auto number = [&](int64_t t) {
        const double z = middle_of(ordered.points, ordered.tets[t]);
        return std::clamp(static_cast<int32_t>(std::floor(z / thickness)), 0, count - 1);
    };
    Array<Block> blocks(count);
    for (int32_t b = 0; b < count; ++b)
        blocks[b] = block_of(piece_of(ordered, [&](int64_t t) { return number(t) == b; }), box, run);
    return blocks;
}

LabelledMesh joined_meshes(Array<Block>& blocks, const Run& run)
{
    LabelledMesh whole = std::move(blocks[0].mesh);
    for (int32_t b = 1; b < blocks.count(); ++b) {
        whole = joined(std::move(whole), blocks[b].mesh, run);
        blocks[b].mesh = LabelledMesh();
    }
    return whole;
}

}  // namespace

int32_t block_count(const Grid& grid, int32_t planes) { return planes > 0 ? std::max(1, grid.dims[2] / planes) : 1; }

LabelledMesh mesh_in_blocks(const Volume& volume, const TetMesh& background, const PipelineOptions& options,
                            const Run& run)
{
    const Grid& grid = volume.grid();
    const int32_t count = block_count(grid, options.block);
    const double thickness = grid.extent()[2] / count;
    Stage stage(run, "blocks", {{nullptr, 1}, {nullptr, 20}, {nullptr, 4}, {nullptr, 60}, {nullptr, 15}});
    Array<Block> blocks = blocks_of(background, count, thickness, {Vec3::Zero(), grid.extent()}, stage.next());
    const auto steps = [&](int32_t pieces) { return Steps(stage.next(), Array<Step>(pieces, {nullptr, 1})); };
    Steps snapping = steps(count);
    for (Block& block : blocks)
        snap_block(volume, block, options, snapping.next());
    Steps seams_snapping = steps(count);
    for_each_seam(count,
                  [&](int32_t b) { snap_seam(volume, blocks[b], blocks[b + 1], options, seams_snapping.next()); });
    Steps meshing = steps(count);
    for (Block& block : blocks)
        mesh_block(volume, block, options, meshing.next());
    Steps seams = steps(count);
    for_each_seam(count, [&](int32_t b) {
        const double plane = thickness * (b + 1);
        const auto is_above = [&](const Array<Vec3>& points, const Tet& tet) {
            return middle_of(points, tet) >= plane;
        };
        improve_seam(volume, blocks[b].mesh, blocks[b + 1].mesh, is_above, options, seams.next());
    });
    run.note("blocks.count", count);
    return joined_meshes(blocks, run);
}

}  // namespace cleft
