// A plane between two blocks is a wall of both boxes. The hull of Delaunay tetrahedra is the Delaunay mesh of the
// points in it: the sphere of a tetrahedron meets the wall in the circle of its triangle, and has no point inside. So
// particles that are the same on both sides make the same triangles.
#include "blocks/block_particles.hpp"

#include "base/parallel.hpp"
#include "base/quiet_run.hpp"
#include "base/stage.hpp"
#include "blocks/block_seams.hpp"
#include "mesh/piece.hpp"
#include "parts/kept_bytes.hpp"
#include "volume/label_planes.hpp"

#include <utility>

namespace cleft
{

namespace
{

// Those that a block has on its walls across the last axis.
struct WallParticles {
    Array<Vec3> low, high;
};

// The numbers of these in the block.
struct CutNumbers {
    Array<int32_t> low, high;

    // A wall with nothing but its corners, which lie on a circle: TetGen may take another diagonal on either side.
    bool has_bare_wall() const
    {
        constexpr int64_t kCorners = 4;
        return low.count() == kCorners || high.count() == kCorners;
    }
    Array<int32_t> all() const
    {
        Array<int32_t> out(low.begin(), low.end());
        out.insert(out.end(), high.begin(), high.end());
        return out;
    }
};

// A block with its sizes as a box that begins at 0.
class BlockBox
{
public:
    BlockBox(const BlockLayout& layout, int32_t block) : layout_(layout), block_(block), grid_(layout.grid)
    {
        grid_.dims[2] = layout.planes(block).count;
        grid_.spacing[2] = layout.thickness() / grid_.dims[2];
    }

    bool has_below() const { return block_ > 0; }
    bool has_above() const { return block_ + 1 < layout_.count; }
    double height() const { return grid_.extent()[2]; }
    // Those of the volume that its own are read from: they need not be at the same heights.
    Planes planes_wanted() const
    {
        constexpr int32_t kBeside = 2;
        return planes_around(layout_.grid, layout_.planes(block_), kBeside);
    }

    SizingField sizes(const SizingField& around, const Run& run) const
    {
        SizingField own{grid_, Array<float>(grid_.size()), around.gradation};
        const Vec3 low(0, 0, layout_.start(block_));
        parallel_for(run, grid_.dims[2], 1, [&](int64_t begin, int64_t end) {
            int64_t v = begin * grid_.plane_size();
            for (int64_t k = begin; k < end; ++k)
                for (int32_t j = 0; j < grid_.dims[1]; ++j)
                    for (int32_t i = 0; i < grid_.dims[0]; ++i, ++v) {
                        const Vec3 centre(i + 0.5, j + 0.5, static_cast<double>(k) + 0.5);
                        own.h[v] = static_cast<float>(around.at(low + centre.cwiseProduct(grid_.spacing)));
                    }
        });
        return own;
    }

    // Numbers of the particles on walls behind which there is another block.
    CutNumbers on_cuts(const Array<Vec3>& particles) const
    {
        CutNumbers out;
        for (int32_t i = 0; i < particles.count(); ++i) {
            if (has_below() && particles[i][2] == 0)
                out.low.push_back(i);
            if (has_above() && particles[i][2] == height())
                out.high.push_back(i);
        }
        return out;
    }

    // From the box to its place in the volume. Both blocks have the same points at a cut, to the last bit.
    void put_in_place(Array<Vec3>& points) const
    {
        const double low = layout_.start(block_);
        const double high = has_above() ? layout_.start(block_ + 1) : layout_.grid.extent()[2];
        for (Vec3& x : points)
            x[2] = x[2] == height() ? high : low + x[2];
    }

private:
    const BlockLayout& layout_;
    int32_t block_;
    Grid grid_;
};

// The particles of the other side of a wall, at the height that it has here.
Array<Vec3> at_height(double height, Array<Vec3> particles)
{
    for (Vec3& x : particles)
        x[2] = height;
    return particles;
}

bool is_first(int32_t block) { return block % 2 == 0; }

class BlockParticles
{
public:
    BlockParticles(const BlockField& sizes, const BlockLayout& layout, const BlockShares& shares,
                   const ParticleOptions& options, Exchange& exchange)
        : sizes_(sizes),
          layout_(layout),
          shares_(shares),
          own_(shares.own(exchange)),
          options_(options),
          exchange_(exchange),
          relaxed_(exchange.scratch()),
          walls_(own_.count)
    {
    }

    void relax_first(const Run& run)
    {
        // Planes of sizes are swapped by all ranks, those with fewer blocks too.
        const int32_t most = shares_.greatest_count();
        Steps steps(run, Array<Step>(most, {nullptr, 1}));
        for (int32_t i = 0; i < most; ++i) {
            const Run of_block = quiet(steps.next());
            const int32_t block = i < own_.count && is_first(own_.first + i) ? own_.first + i : -1;
            const SizingField around = sizes_around(block);
            if (block < 0)
                continue;
            const BlockBox box(layout_, block);
            const Array<Vec3> particles = relaxed_particles(box.sizes(around, of_block), options_, {}, of_block);
            const CutNumbers on_cuts = box.on_cuts(particles);
            walls_[i] = {places_of(particles, on_cuts.low), places_of(particles, on_cuts.high)};
            relaxed_.put(block, particles);
        }
    }

    // The others get the walls of their neighbours.
    void hand_over_walls()
    {
        for (int32_t i = 0; i < own_.count; ++i) {
            if (is_first(own_.first + i))
                continue;
            if (i > 0)
                walls_[i].low = std::exchange(walls_[i - 1].high, {});
            if (i + 1 < own_.count)
                walls_[i].high = std::exchange(walls_[i + 1].low, {});
        }
        const bool below = own_.count > 0 && own_.first > 0;
        const bool above = own_.count > 0 && own_.end() < shares_.blocks();
        Parcel down, up;
        if (below && is_first(own_.first))
            down.put(walls_.front().low);
        if (above && is_first(own_.end() - 1))
            up.put(walls_.back().high);
        auto [from_below, from_above] = NeighbourMail(shares_, exchange_).swap(down, up);
        if (below && !is_first(own_.first))
            from_below.take(walls_.front().low);
        if (above && !is_first(own_.end() - 1))
            from_above.take(walls_.back().high);
    }

    TetMesh background(int32_t block, const Run& run)
    {
        const SizingField around = sizes_around(block < 0 || is_first(block) ? -1 : block);
        if (block < 0)
            return {};
        const BlockBox box(layout_, block);
        Steps steps(quiet(run), {{nullptr, 37}, {nullptr, 63}});
        const Run of_particles = steps.next();
        Array<Vec3> particles = is_first(block) ? taken_out(block)
                                                : relaxed_between(box, walls_[block - own_.first],
                                                                  box.sizes(around, of_particles), of_particles);
        const CutNumbers on_cuts = box.on_cuts(particles);
        ParticleOptions options = options_;
        if (on_cuts.has_bare_wall())
            options.delaunay = DelaunayEngine::cleft;
        TetMesh mesh = mesh_of_particles(std::move(particles), on_cuts.all(), options, steps.next());
        box.put_in_place(mesh.points);
        return mesh;
    }

private:
    SizingField sizes_around(int32_t block)
    {
        return swapped_planes(sizes_, block < 0 ? Planes{} : BlockBox(layout_, block).planes_wanted(), exchange_);
    }

    Array<Vec3> taken_out(int32_t block)
    {
        Array<Vec3> particles = relaxed_.get<Vec3>(block);
        relaxed_.put(block, Array<Vec3>());
        return particles;
    }

    Array<Vec3> relaxed_between(const BlockBox& box, WallParticles& walls, const SizingField& sizes, const Run& run)
    {
        const Array<Vec3> low = at_height(0, std::move(walls.low));
        const Array<Vec3> high = at_height(box.height(), std::move(walls.high));
        return relaxed_particles(sizes, options_, {box.has_below() ? &low : nullptr, box.has_above() ? &high : nullptr},
                                 run);
    }

    const BlockField& sizes_;
    const BlockLayout& layout_;
    const BlockShares shares_;
    const OwnBlocks own_;
    const ParticleOptions options_;
    Exchange& exchange_;
    KeptBytes relaxed_;           // by block
    Array<WallParticles> walls_;  // by own block: those that it gives away, or gets
};

}  // namespace

bool have_room_for_particles(const BlockLayout& layout, const SizeRange& sizes)
{
    constexpr double kThickness = 2;  // in sizes
    return layout.thickness() >= kThickness * sizes.greatest;
}

BackgroundOfBlock particles_of_blocks(const BlockField& sizes, const BlockLayout& layout, const BlockShares& shares,
                                      const ParticleOptions& options, Exchange& exchange, const Run& run)
{
    const auto blocks = std::make_shared<BlockParticles>(sizes, layout, shares, options, exchange);
    blocks->relax_first(run);
    blocks->hand_over_walls();
    return [blocks](int32_t block, const Run& of_block) { return blocks->background(block, of_block); };
}

TetMesh particles_in_blocks(const SizingField& sizes, const BlockLayout& layout, const ParticleOptions& options,
                            const Run& run)
{
    Steps steps(run, {{nullptr, 20}, {nullptr, 80}});
    Exchange alone = Exchange::alone();
    BlockField field(layout.grid, sizes.gradation, "");
    field.add({0, layout.grid.dims[2]}, sizes.h);
    const BackgroundOfBlock of_block =
        particles_of_blocks(field, layout, BlockShares::equal(layout.count, 1), options, alone, steps.next());
    Steps blocks(steps.next(), Array<Step>(layout.count, {nullptr, 1}));
    LabelledMesh whole;
    for (int32_t b = 0; b < layout.count; ++b) {
        TetMesh block = of_block(b, blocks.next());
        Array<Material> one(block.tets.size(), 0);
        whole = joined(std::move(whole), {std::move(block.points), std::move(block.tets), std::move(one)}, run);
    }
    return {std::move(whole.points), std::move(whole.tets)};
}

}  // namespace cleft
