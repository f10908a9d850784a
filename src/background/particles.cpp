// The particle background of the paper, section 3: seeds, relaxation, Delaunay, and then the repair of slivers.
#include "background/particles.hpp"

#include "background/relaxation.hpp"
#include "background/repair.hpp"
#include "background/seeding.hpp"
#include "base/parallel.hpp"
#include "base/random.hpp"
#include "base/stage.hpp"

#include <numeric>

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
                if (!held(particles.walls[i], a))
                    x[a] += kJitter * h * (2 * unit_random(variation + 2, static_cast<uint64_t>(3 * i + a)) - 1);
        }
    });
}

// Corners, edges, faces, inside; else in the order that they have.
// An order that callers rely on; Delaunay has an insertion order of its own.
Array<Vec3> walls_first(const ParticleSet& particles)
{
    Array<Vec3> out;
    out.reserve(particles.size());
    for (int walls = 3; walls >= 0; --walls)
        for (size_t i = 0; i < particles.size(); ++i)
            if (wall_count(particles.walls[i]) == walls)
                out.push_back(particles.x[i]);
    return out;
}

}  // namespace

Array<Vec3> relaxed_particles(const SizingField& field, const ParticleOptions& options, const Run& run)
{
    const SizeSampler size(field);
    Steps steps(run, {{nullptr, 12}, {nullptr, 88}});
    Seeds seeds;
    {
        Stage stage(steps.next(), "background.seed", {{"background: seeding", 1}});
        seeds = seed_particles(field, size, options.seed, stage.next());
    }
    run.note("background.particles", static_cast<double>(seeds.particles.size()));
    if (!seeds.at_rest) {
        Stage stage(steps.next(), "background.relax", {{"background: relaxing the particles", 1}});
        relax(seeds.particles, field, size, options.steps, stage.next());
    }
    jitter(seeds.particles, size, options.seed, run);
    return walls_first(seeds.particles);
}

TetMesh particle_background(const SizingField& field, const ParticleOptions& options, const Run& run)
{
    TetMesh mesh;
    Steps steps(run, {{nullptr, 37}, {nullptr, 36}, {nullptr, 27}});
    mesh.points = relaxed_particles(field, options, steps.next());
    {
        Stage stage(steps.next(), "background.delaunay", {{"background: Delaunay", 1}});
        mesh.tets = delaunay(mesh.points, options.delaunay, stage.next());
    }
    repair(mesh, RepairOptions{}, steps.next());
    return mesh;
}

}  // namespace cleft
