// The particle background of the paper, section 3: seeds, relaxation, Delaunay, and then the repair of slivers.
#include "background/particles.hpp"

#include "background/relaxation.hpp"
#include "background/repair.hpp"
#include "background/seeding.hpp"
#include "base/parallel.hpp"
#include "base/random.hpp"
#include "base/stage.hpp"
#include "mesh/piece.hpp"

#include <algorithm>
#include <utility>

namespace cleft
{

namespace
{

// Far below anything that an angle could show, and enough for Delaunay to find no five points on a sphere in a lattice.
constexpr double kJitter = 1e-9;  // in h

void jitter(ParticleSet& particles, const SizeSampler& size, uint64_t variation, const Run& run)
{
    parallel_for(run, particles.count(), 4096, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            Vec3& x = particles.x[i];
            const double h = static_cast<double>(size(x));
            for (int a = 0; a < 3; ++a)
                // A wall coordinate stays exact, for later stages find the walls by comparing it.
                if (may_move(particles.walls[i], a))
                    x[a] += kJitter * h * (2 * unit_random(variation + 2, static_cast<uint64_t>(3 * i + a)) - 1);
        }
    });
}

// Corners, edges, faces, inside; else in the order that they have.
// An order that callers rely on; Delaunay has an insertion order of its own.
Array<Vec3> walls_first(const ParticleSet& particles)
{
    constexpr int kCorner = 3;
    Array<Vec3> out;
    out.reserve(particles.size());
    for (int walls = kCorner; walls >= 0; --walls) {
        for (size_t i = 0; i < particles.size(); ++i)
            if (wall_count(particles.walls[i]) == walls)
                out.push_back(particles.x[i]);
        // The four of a wall without others lie on a circle, and their numbers decide about the diagonal. Boxes on both
        // sides of it must take the same.
        if (walls == kCorner)
            std::sort(out.begin(), out.end(), is_lower_place);
    }
    return out;
}

// Those of a wall across the last axis make room for what is given.
void give_wall(ParticleSet& particles, const Array<Vec3>& given, double place, const Vec3& extent)
{
    constexpr int kAxis = 2;
    const ParticleSet before = std::exchange(particles, ParticleSet());
    for (size_t i = 0; i < before.size(); ++i)
        if (!held(before.walls[i], kAxis) || before.x[i][kAxis] != place)
            particles.add(before.x[i], before.walls[i]);
    for (const Vec3& x : given) {
        CLEFT_ASSERT(x[kAxis] == place);
        Walls walls = kFixed;
        for (int a = 0; a < 3; ++a)
            if (a == kAxis || x[a] == 0 || x[a] == extent[a])
                walls = static_cast<Walls>(walls | 1 << a);
        particles.add(x, walls);
    }
}

}  // namespace

Array<Vec3> relaxed_particles(const SizingField& field, const ParticleOptions& options, const GivenWalls& given,
                              const Run& run)
{
    const SizeSampler size(field);
    Steps steps(run, {{nullptr, 12}, {nullptr, 88}});
    Seeds seeds;
    {
        Stage stage(steps.next(), "background.seed", {{"background: seeding", 1}});
        seeds = seed_particles(field, size, options.seed, stage.next());
    }
    const Vec3& extent = size.extent();
    if (given.low)
        give_wall(seeds.particles, *given.low, 0, extent);
    if (given.high)
        give_wall(seeds.particles, *given.high, extent[2], extent);
    run.note("background.particles", static_cast<double>(seeds.particles.size()));
    if (!seeds.at_rest || given.any()) {
        Stage stage(steps.next(), "background.relax", {{"background: relaxing the particles", 1}});
        relax(seeds.particles, field, size, options.steps, stage.next());
    }
    jitter(seeds.particles, size, options.seed, run);
    return walls_first(seeds.particles);
}

TetMesh mesh_of_particles(Array<Vec3> particles, const Array<int32_t>& held, const ParticleOptions& options,
                          const Run& run)
{
    Steps steps(run, {{nullptr, 36}, {nullptr, 27}});
    TetMesh mesh;
    mesh.points = std::move(particles);
    {
        Stage stage(steps.next(), "background.delaunay", {{"background: Delaunay", 1}});
        mesh.tets = delaunay(mesh.points, options.delaunay, stage.next());
    }
    RepairOptions repairing;
    repairing.held = Array<int32_t>(held.begin(), held.end());
    repair(mesh, repairing, steps.next());
    return mesh;
}

TetMesh particle_background(const SizingField& field, const ParticleOptions& options, const Run& run)
{
    Steps steps(run, {{nullptr, 37}, {nullptr, 63}});
    Array<Vec3> particles = relaxed_particles(field, options, {}, steps.next());
    return mesh_of_particles(std::move(particles), {}, options, steps.next());
}

}  // namespace cleft
