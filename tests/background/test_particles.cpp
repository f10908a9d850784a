// Relaxed particles: where they are, how dense, what stays the same, and boxes of any shape.
#include "background/particle_tree.hpp"
#include "background/particles.hpp"
#include "background/relaxation.hpp"
#include "background/seeding.hpp"
#include "delaunay/delaunay.hpp"
#include "fields.hpp"
#include "mesh/quality.hpp"
#include "support/cmocka.hpp"

#include <cstring>

using namespace cleft;
using namespace cleft::test;

namespace
{

constexpr double kPi = 3.14159265358979323846;

// Size doubles three times, with both of its limits in the box.
SizingField graded_field() { return ball_field({64, 56, 48}, Vec3(1, 1, 1), 1, 8, 0.3); }

ParticleSet relaxed(const SizingField& field, int steps, const Run& run)
{
    const SizeSampler size(field);
    ParticleSet particles = seed_particles(field, size, 0, run).particles;
    relax(particles, field, size, steps, run);
    return particles;
}

// visit(x, charge) over the box, eight points a voxel.
template <class Visit>
void for_charge(const SizingField& field, const Visit& visit)
{
    const Grid& grid = field.grid;
    const double cell = grid.spacing.prod() / 8;
    for (int32_t k = 0; k < 2 * grid.dims[2]; ++k)
        for (int32_t j = 0; j < 2 * grid.dims[1]; ++j)
            for (int32_t i = 0; i < 2 * grid.dims[0]; ++i) {
                const Vec3 x = (Vec3(i, j, k).array() * 0.5 + 0.25).matrix().cwiseProduct(grid.spacing);
                visit(x, kParticleDensity[3] * cell / std::pow(field.at(x), 3));
            }
}

constexpr size_t kBins = 6;  // half octaves of the size, from 1

size_t bin_of(double h) { return static_cast<size_t>(std::clamp(2 * std::log2(h), 0.0, kBins - 1.0)); }

// Particles over charge in each bin of the size.
std::array<double, kBins> density_by_size(const SizingField& field, const ParticleSet& particles)
{
    std::array<double, kBins> charge{}, found{};
    for_charge(field, [&](const Vec3& x, double q) { charge[bin_of(field.at(x))] += q; });
    for (size_t i = 0; i < particles.size(); ++i)
        found[bin_of(field.at(particles.x[i]))] += share_of_box(particles.walls[i]);
    for (size_t b = 0; b < kBins; ++b)
        found[b] /= charge[b];
    return found;
}

// Mean over the waves of numbers up to three along each axis of |particles - charge|^2 over the number of particles:
// one half to one for particles placed at random.
double long_wave_power(const SizingField& field, const ParticleSet& particles)
{
    constexpr int kWaves = 4;
    std::array<double, kWaves * kWaves * kWaves> amplitude{};
    const auto add = [&](const Vec3& x, double charge) {
        const Vec3 phase = kPi * x.cwiseQuotient(field.grid.extent());
        std::array<std::array<double, kWaves>, 3> c;
        for (size_t a = 0; a < 3; ++a)
            for (size_t k = 0; k < kWaves; ++k)
                c[a][k] = std::cos(static_cast<double>(k) * phase[static_cast<int>(a)]);
        for (size_t n = 0; n < amplitude.size(); ++n)
            amplitude[n] += charge * c[0][n % 4] * c[1][n / 4 % 4] * c[2][n / 16];
    };
    for_charge(field, [&](const Vec3& x, double q) { add(x, -q); });
    double all = 0;
    for (size_t i = 0; i < particles.size(); ++i) {
        add(particles.x[i], share_of_box(particles.walls[i]));
        all += share_of_box(particles.walls[i]);
    }
    double power = 0;
    for (size_t n = 1; n < amplitude.size(); ++n)  // the first is the charge of the whole box
        power += amplitude[n] * amplitude[n];
    return power / all / static_cast<double>(amplitude.size() - 1);
}

struct Mesh {
    Array<Vec3> points;
    Array<Tet> tets;
};

Mesh delaunay_of(const SizingField& field)
{
    Mesh mesh;
    mesh.points = relaxed_particles(field, ParticleOptions(), {}, Run());
    mesh.tets = delaunay(mesh.points, DelaunayEngine::cleft, Run());
    return mesh;
}

// Volume over that of the box; negative if a tetrahedron is not positive.
double filling(const Array<Vec3>& points, const Array<Tet>& tets, const Vec3& extent)
{
    double volume = 0;
    for (const Tet& t : tets) {
        const auto p = [&](size_t i) { return points[t[i]]; };
        const double six = orient(p(0), p(1), p(2), p(3));
        if (!(six > 0))
            return -1;
        volume += six / 6;
    }
    return volume / extent.prod();
}

}  // namespace

static void density_follows_the_charge_in_every_size(void**)
{
    const SizingField field = graded_field();
    const std::array<double, kBins> density = density_by_size(field, relaxed(field, ParticleOptions().steps, Run()));
    for (size_t b = 0; b < kBins; ++b)
        print_message("h from %.2f: density %.3f\n", std::exp2(0.5 * static_cast<double>(b)), density[b]);
    for (const double d : density)
        assert_true(std::abs(d - 1) < 0.08);
}

static void density_follows_the_charge_in_long_waves(void**)
{
    const SizingField field = graded_field();
    const double power = long_wave_power(field, relaxed(field, ParticleOptions().steps, Run()));
    print_message("power of long waves %.4f\n", power);
    assert_true(power < 0.05);
}

static void coarse_places_are_not_drained(void**)
{
    // Next to all of the charge is in a corner: what the seeds miss of it must not be taken from elsewhere.
    SizingField field = ball_field({96, 96, 96}, Vec3(1, 1, 1), 1, 96, 0.3);
    const SizeSampler size(field);
    ParticleSet particles = seed_particles(field, size, 0, Run()).particles;
    const auto coarse = [&] {
        double sum = 0;
        for (size_t i = 0; i < particles.size(); ++i)
            sum += size(particles.x[i]) > 10 ? share_of_box(particles.walls[i]) : 0;
        return sum;
    };
    const double before = coarse();
    relax(particles, field, size, ParticleOptions().steps, Run());
    print_message("coarse charge %.1f of %.1f\n", coarse(), before);
    assert_true(before > 50);
    assert_true(std::abs(coarse() / before - 1) < 0.1);
}

static void relaxation_calms_down(void**)
{
    Metrics metrics;
    Run run;
    run.metrics = &metrics;
    ParticleOptions options;
    relaxed_particles(graded_field(), options, {}, run);
    for (int step = 1; step <= options.steps; ++step) {
        const std::string name = "background.step." + std::to_string(step);
        assert_true(metrics.get(name + ".movement", -1) > 0);
        assert_true(metrics.get(name + ".density_error", -1) > 0);
    }
    const std::string last = "background.step." + std::to_string(options.steps);
    assert_true(metrics.get(last + ".movement") < 0.75 * metrics.get("background.step.1.movement"));
    assert_true(metrics.get(last + ".density_error") < metrics.get("background.step.1.density_error"));
}

static void particles_of_walls_slide_in_them(void**)
{
    const SizingField field = graded_field();
    const SizeSampler size(field);
    const Vec3 extent = field.grid.extent();
    const ParticleSet seeds = seed_particles(field, size, 0, Run()).particles;
    const Array<int32_t> order = tree_order(seeds.x, Run());
    ParticleSet particles = seeds;
    relax(particles, field, size, 3, Run());
    assert_int_equal(particles.size(), seeds.size());
    std::array<int, 4> count{}, moved{};
    for (size_t i = 0; i < particles.size(); ++i) {
        const auto from = static_cast<size_t>(order[i]);
        assert_int_equal(particles.walls[i], seeds.walls[from]);
        for (int a = 0; a < 3; ++a) {
            const double x = particles.x[i][a];
            if (held(particles.walls[i], a))
                assert_true(x == seeds.x[from][a] && (x == 0 || x == extent[a]));
            else
                assert_true(x > 0 && x < extent[a]);
        }
        const auto walls = static_cast<size_t>(wall_count(particles.walls[i]));
        ++count[walls];
        moved[walls] += particles.x[i] != seeds.x[from];
    }
    assert_int_equal(count[3], 8);
    assert_int_equal(moved[3], 0);
    for (const size_t walls : {size_t{0}, size_t{1}, size_t{2}}) {
        assert_true(count[walls] > 20);
        assert_true(moved[walls] > 0.9 * count[walls]);
    }
}

static void corners_edges_and_faces_come_first(void**)
{
    const SizingField field = ball_field({24, 20, 16}, Vec3(1, 1, 1), 2, 6, 0.3);
    const Vec3 extent = field.grid.extent();
    int last = 3, corners = 0;
    for (const Vec3& x : relaxed_particles(field, ParticleOptions(), {}, Run())) {
        int walls = 0;
        for (int a = 0; a < 3; ++a)
            walls += x[a] == 0 || x[a] == extent[a];
        assert_true(walls <= last);
        last = walls;
        corners += walls == 3;
    }
    assert_int_equal(corners, 8);
    assert_int_equal(last, 0);
}

static void threads_do_not_matter_and_the_seed_does(void**)
{
    const SizingField field = graded_field();
    Run two;
    two.threads = 2;
    ParticleOptions other;
    other.seed = 1;
    const Array<Vec3> one = relaxed_particles(field, ParticleOptions(), {}, Run());
    assert_true(one == relaxed_particles(field, ParticleOptions(), {}, two));
    const Array<Vec3> varied = relaxed_particles(field, other, {}, Run());
    assert_true(one != varied);
    assert_true(varied == relaxed_particles(field, other, {}, two));
    const double ratio = static_cast<double>(varied.size()) / static_cast<double>(one.size());
    assert_true(std::abs(ratio - 1) < 0.01);
}

static void boxes_of_any_shape_are_filled(void**)
{
    const Grid grids[] = {
        {{1, 1, 1}, Vec3(1, 1, 1)},         {{1, 1, 1}, Vec3(1, 1, 100)},
        {{20, 20, 1}, Vec3(1, 1, 1)},       {{1, 20, 20}, Vec3(1, 1, 1)},
        {{40, 1, 1}, Vec3(1, 1, 1)},        {{2, 2, 2}, Vec3(1, 1, 1)},
        {{16, 16, 4}, Vec3(0.5, 0.5, 3)},   {{30, 30, 1}, Vec3(1, 1, 0.001)},
        {{300, 2, 2}, Vec3(1, 0.01, 0.01)}, {{12, 10, 8}, Vec3(1e-6, 1e-6, 3e-6)},
    };
    for (const Grid& grid : grids)
        for (const double size : {1.0, 2.5, 50.0}) {
            const double h = size * grid.spacing.maxCoeff();
            SizingField field = constant_sizing(grid, h);
            for (size_t v = 0; v < field.h.size(); ++v)  // no lattice where sizes grow
                field.h[v] *= 1 + 0.3F * static_cast<float>(v % 20) / 20;
            for (const SizingField& f : {constant_sizing(grid, h), field}) {
                const TetMesh mesh = particle_background(f, ParticleOptions(), Run());
                assert_true(std::abs(filling(mesh.points, mesh.tets, grid.extent()) - 1) < 1e-9);
            }
        }
}

static void scale_does_not_matter(void**)
{
    const SizingField field = ball_field({24, 20, 16}, Vec3(1, 1, 1), 1.5, 6, 0.3);
    const Mesh mesh = delaunay_of(field);
    for (const int exponent : {-20, 20}) {  // powers of two are exact
        const Mesh scaled_mesh = delaunay_of(scaled(field, std::ldexp(1.0, exponent)));
        assert_true(scaled_mesh.tets == mesh.tets);
    }
    for (const double factor : {1e-6, 1e6}) {
        const SizingField other = scaled(field, factor);
        const Mesh scaled_mesh = delaunay_of(other);
        assert_int_equal(scaled_mesh.points.size(), mesh.points.size());
        assert_true(std::abs(filling(scaled_mesh.points, scaled_mesh.tets, other.grid.extent()) - 1) < 1e-9);
        const double ratio = static_cast<double>(scaled_mesh.tets.size()) / static_cast<double>(mesh.tets.size());
        assert_true(std::abs(ratio - 1) < 0.002);
    }
}

static void too_many_are_refused_at_once(void**)
{
    const auto refusal = [](const SizingField& field) -> std::string {
        try {
            relaxed_particles(field, ParticleOptions(), {}, Run());
        } catch (const Error& error) {
            return error.status() == CLEFT_ERROR_TOO_LARGE ? error.what() : "another error";
        }
        return "";
    };
    const std::string cube = refusal(constant_sizing(Grid{{100, 100, 100}, Vec3(1, 1, 1)}, 0.25));
    assert_non_null(std::strstr(cube.c_str(), "687 million tetrahedra"));
    assert_non_null(std::strstr(cube.c_str(), "size_min"));
    assert_non_null(std::strstr(cube.c_str(), "tets"));
    // A plate so thin that its particles are those of its two faces.
    const std::string plate = refusal(constant_sizing(Grid{{1000, 1000, 1}, Vec3(1, 1, 1e-4)}, 0.1));
    assert_non_null(std::strstr(plate.c_str(), "million tetrahedra"));
    const std::string absurd = refusal(constant_sizing(Grid{{10, 10, 10}, Vec3(1, 1, 1)}, 1e-30));
    assert_non_null(std::strstr(absurd.c_str(), "million tetrahedra"));
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(density_follows_the_charge_in_every_size),
        cmocka_unit_test(density_follows_the_charge_in_long_waves),
        cmocka_unit_test(coarse_places_are_not_drained),
        cmocka_unit_test(relaxation_calms_down),
        cmocka_unit_test(particles_of_walls_slide_in_them),
        cmocka_unit_test(corners_edges_and_faces_come_first),
        cmocka_unit_test(threads_do_not_matter_and_the_seed_does),
        cmocka_unit_test(boxes_of_any_shape_are_filled),
        cmocka_unit_test(scale_does_not_matter),
        cmocka_unit_test(too_many_are_refused_at_once),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
