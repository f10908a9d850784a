// Moves the particles in their forces, as damped charges: the electrostatic simulation of section 3 of the paper.
#include "background/relaxation.hpp"

#include "background/forces.hpp"
#include "background/long_waves.hpp"
#include "background/near_attraction.hpp"
#include "background/near_repulsion.hpp"
#include "background/particle_tree.hpp"
#include "base/parallel.hpp"

#include <cmath>
#include <string>

namespace cleft
{

namespace
{

// The natural step of a charge in the field of its displacement is the force over the square of the plasma frequency,
// 4 pi rho. Near forces are spread over all directions and bear more than three times their share; a long wave would
// swing over with more than one.
constexpr float kNearGain = 3, kWaveGain = 1;
// Of the last move. Without it density travels slowly over many particles; with much more they swing about their
// places.
constexpr float kMomentum = 0.5F;
// The lists of who is near rest on this bound. It also keeps two seeds that lie close together from shooting apart.
constexpr float kLongestMove = 0.15F;  // in h
// The attraction by the background changes little from step to step, who is near changes still less.
// With the attraction renewed every second step, eight steps give the angles that ten gave before.
constexpr int kAttractionLasts = 2, kListsLast = 4;
// A particle does not come nearer to a wall than this many h, nor does one on a wall to an edge.
// A particle nearer to a wall would make a flat tetrahedron with those in the wall.
constexpr double kClearance = 0.1;

// To first order, a move of the force over the divergence takes the force of the background away.
constexpr auto kStepScale = static_cast<float>(1 / kBackgroundDivergence);

struct Motion {
    Array<float> h, reach;
    Array<Eigen::Vector3f> attraction, force, velocity;  // in units of h of the particle

    explicit Motion(int64_t n) : h(n), reach(n), attraction(n), force(n), velocity(n, Eigen::Vector3f::Zero()) {}
};

ParticleSet in_order(const ParticleSet& particles, const Array<int32_t>& order)
{
    ParticleSet out;
    out.x.reserve(order.size());
    out.walls.reserve(order.size());
    for (const int32_t i : order)
        out.add(particles.x[i], particles.walls[i]);
    return out;
}

void read_sizes(const ParticleSet& particles, const SizeSampler& size, bool attraction_too, Motion& motion,
                const Run& run)
{
    parallel_for(run, particles.count(), 1024, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            motion.h[i] = size(particles.x[i]);
            motion.reach[i] = kReach * motion.h[i];
            if (attraction_too)
                motion.attraction[i] = near_attraction(size, particles.x[i], motion.h[i]);
        }
    });
}

// A box thinner than two clearances holds its particles in its middle.
double moved(double x, double by, double length, double clearance)
{
    CLEFT_ASSERT(std::isfinite(by));
    const double margin = std::min(clearance, 0.5 * length);
    return std::clamp(x + by, margin, length - margin);
}

// One step of each particle in the forces that act on all; the sum of the squared moves, in h.
double move(ParticleSet& particles, Motion& motion, const LongWaves& waves, const Vec3& extent, const Run& run)
{
    // Sums are kept per chunk and added in order: the metric is the same for any number of threads.
    constexpr int64_t kGrain = 1024;
    const auto n = particles.count();
    Array<double> sums(chunk_count(n, kGrain));
    parallel_chunks(run, n, kGrain, [&](int64_t chunk, int64_t begin, int64_t end) {
        double sum = 0;
        for (int64_t i = begin; i < end; ++i) {
            const double h = static_cast<double>(motion.h[i]);
            const Eigen::Vector3f wave =
                (field_at(waves, particles.x[i], static_cast<double>(motion.reach[i])) * (h * h)).cast<float>();
            const Eigen::Vector3f near = motion.force[i] + motion.attraction[i];
            Eigen::Vector3f v = kMomentum * motion.velocity[i] + kStepScale * (kNearGain * near + kWaveGain * wave);
            const Walls walls = particles.walls[i];
            for (int a = 0; a < 3; ++a)
                if (!may_move(walls, a))
                    v[a] = 0;
            v *= std::min(1.0F, kLongestMove / std::max(v.norm(), 1e-30F));
            motion.velocity[i] = v;
            for (int a = 0; a < 3; ++a)
                if (may_move(walls, a))
                    particles.x[i][a] =
                        moved(particles.x[i][a], h * static_cast<double>(v[a]), extent[a], kClearance * h);
            sum += static_cast<double>(v.squaredNorm());
        }
        sums[chunk] = sum;
    });
    double all = 0;
    for (const double s : sums)
        all += s;
    return all;
}

}  // namespace

void relax(ParticleSet& particles, const SizingField& field, const SizeSampler& size, int steps, const Run& run)
{
    // Near particles then are near in memory. This order is kept although they move, for in eight steps none moves by
    // more than 1.2 h.
    particles = in_order(particles, tree_order(particles.x, run));
    ParticleTree tree = make_tree(particles.count());
    Motion motion(particles.count());
    const auto [least, greatest] = std::minmax_element(field.h.begin(), field.h.end());
    LongWaves waves = make_long_waves(size, *least, *greatest, particles, run);
    Array<NearGroup> near;
    for (int step = 0; step < steps; ++step) {
        run.report(static_cast<double>(step) / steps);
        read_sizes(particles, size, step % kAttractionLasts == 0, motion, run);
        if (step % kListsLast == 0) {
            fit_boxes(tree, particles.x, motion.reach, run);
            find_near(tree, particles, size.extent(), near, run);
        }
        near_repulsion(near, particles, motion.reach, size.extent(), motion.force, run);
        const double density_error = solve_poisson(waves, particles, run);
        const double sum = move(particles, motion, waves, size.extent(), run);
        if (run.metrics) {
            const std::string name = "background.step." + std::to_string(step + 1);
            run.note(name + ".movement", std::sqrt(sum / static_cast<double>(particles.size())));
            run.note(name + ".density_error", density_error);
        }
    }
}

}  // namespace cleft
