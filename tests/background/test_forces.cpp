// The forces that move particles against the exact electrostatic forces of a mirrored box.
#include "background/forces.hpp"
#include "background/long_waves.hpp"
#include "background/near_attraction.hpp"
#include "background/near_repulsion.hpp"
#include "background/seeding.hpp"
#include "ewald.hpp"
#include "fields.hpp"
#include "support/cmocka.hpp"

using namespace cleft;
using namespace cleft::test;

namespace
{

ParticleSet in_tree_order(const ParticleSet& particles)
{
    ParticleSet out;
    for (const int32_t i : tree_order(particles.x, Run()))
        out.add(particles.x[i], particles.walls[i]);
    return out;
}

// The force on each particle, unit charges, as relaxation has it.
Array<Vec3> our_forces(const SizingField& field, const SizeSampler& size, const ParticleSet& particles)
{
    const Run run;
    const int64_t n = particles.count();
    Array<float> h(n), reach(n);
    for (int64_t i = 0; i < n; ++i) {
        h[i] = size(particles.x[i]);
        reach[i] = kReach * h[i];
    }
    ParticleTree tree = make_tree(n);
    fit_boxes(tree, particles.x, reach, run);
    Array<NearGroup> groups;
    find_near(tree, particles, size.extent(), groups, run);
    Array<Eigen::Vector3f> near(n);
    near_repulsion(groups, particles, reach, size.extent(), near, run);
    LongWaves waves = make_long_waves(size, field.range().least, field.range().greatest, particles, run);
    solve_poisson(waves, particles, run);
    Array<Vec3> force(n);
    for (int64_t i = 0; i < n; ++i) {
        const Eigen::Vector3f f = near[i] + near_attraction(size, particles.x[i], h[i]);
        force[i] = f.cast<double>() / static_cast<double>(h[i] * h[i]) +
                   field_at(waves, particles.x[i], static_cast<double>(reach[i]));
    }
    return force;
}

struct Agreement {
    double error;        // root mean square of the difference over that of the force
    double correlation;  // cosine of the angle between all forces together
};

// Of the components that can move a particle, each times h^2: the particle moves by a fixed share of that in units of
// h.
Agreement compare(const Array<Vec3>& ours, const Array<Vec3>& exact, const SizeSampler& size,
                  const ParticleSet& particles)
{
    double difference = 0, ours2 = 0, exact2 = 0, both = 0;
    for (size_t i = 0; i < particles.size(); ++i) {
        const double h = static_cast<double>(size(particles.x[i])), weight = h * h * h * h;
        for (int a = 0; a < 3; ++a)
            if (!held(particles.walls[i], a)) {
                const double f = ours[i][a], e = exact[i][a];
                difference += weight * (f - e) * (f - e);
                ours2 += weight * f * f;
                exact2 += weight * e * e;
                both += weight * f * e;
            }
    }
    return {std::sqrt(difference / exact2), both / std::sqrt(ours2 * exact2)};
}

Agreement agreement_in(const SizingField& field, double alpha)
{
    const SizeSampler size(field);
    const ParticleSet particles = in_tree_order(seed_particles(field, size, 0, Run()).particles);
    const ewald::Sum sum = ewald::make_sum(size, field.range().least, alpha);
    const Array<Vec3> exact = ewald::forces(sum, particles, 96);
    const Agreement agreement = compare(our_forces(field, size, particles), exact, size, particles);
    print_message("%zu particles: error %.3f, correlation %.4f\n", particles.size(), agreement.error,
                  agreement.correlation);
    return agreement;
}

}  // namespace

static void forces_are_near_the_exact_ones_where_sizes_grow_fast(void**)
{
    const Agreement graded = agreement_in(ball_field({40, 36, 32}, Vec3(1, 1, 1), 2, 8, 0.3), 1.2);
    assert_true(graded.error < 0.25);
    assert_true(graded.correlation > 0.97);
}

static void forces_are_near_the_exact_ones_in_a_box_that_is_no_cube(void**)
{
    const Agreement graded = agreement_in(ball_field({48, 24, 12}, Vec3(0.5, 1, 2), 3, 8, 0.2), 1.2);
    assert_true(graded.error < 0.1);
    assert_true(graded.correlation > 0.99);
}

// The mirrors: a single particle is pushed away from the wall that it is near.
static void a_wall_repels(void**)
{
    SizingField field = constant_sizing(Grid{{16, 16, 16}, Vec3(1, 1, 1)}, 2);
    const SizeSampler size(field);
    ParticleSet particles;
    particles.add(Vec3(0.3, 8, 8), 0);
    particles.add(Vec3(8, 15.7, 8), 0);
    particles.add(Vec3(0, 15.7, 8), 1);  // in the wall x = 0
    const Array<float> reach(3, 2 * kReach);
    ParticleTree tree = make_tree(3);
    fit_boxes(tree, particles.x, reach, Run());
    Array<NearGroup> groups;
    find_near(tree, particles, size.extent(), groups, Run());
    Array<Eigen::Vector3f> force(3);
    near_repulsion(groups, particles, reach, size.extent(), force, Run());
    assert_true(force[0].x() > 1 && std::abs(force[0].y()) < 1e-3F && std::abs(force[0].z()) < 1e-3F);
    assert_true(force[1].y() < -1 && std::abs(force[1].x()) < 1e-3F && std::abs(force[1].z()) < 1e-3F);
    assert_true(std::abs(force[2].x()) < 1e-3F && force[2].y() < -1);
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(forces_are_near_the_exact_ones_where_sizes_grow_fast),
        cmocka_unit_test(forces_are_near_the_exact_ones_in_a_box_that_is_no_cube),
        cmocka_unit_test(a_wall_repels),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
