// One surface on a uniform lattice: before any improving, dihedral angles away from the box lie within the bound that
// Labelle and Shewchuk publish for isosurface stuffing, 10.7 to 164.8 degrees. Random smooth level sets, through the C
// interface.
#include "cleft/cleft.h"
#include "support/cmocka.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

using cleft_test::Random;

namespace
{

constexpr int kVoxels = 16;
constexpr int kLevelSets = 150;
constexpr double kLeast = 10.7, kGreatest = 164.8;

struct Vector {
    double x, y, z;
};

Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(const Vector& a, const Vector& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Vector random_vector(Random& random, double low, double high)
{
    const double x = random.between(low, high), y = random.between(low, high), z = random.between(low, high);
    return {x, y, z};
}

Vector random_direction(Random& random)
{
    const Vector v = random_vector(random, -1, 1);
    const double length = std::sqrt(dot(v, v));
    return {v.x / length, v.y / length, v.z / length};
}

using LevelSet = std::function<double(const Vector&)>;

LevelSet random_waves(Random& random)
{
    struct Wave {
        Vector frequency;
        double amplitude, phase;
    };
    std::vector<Wave> waves;
    for (int i = 0; i < 6; ++i) {
        const Vector frequency = random_vector(random, -0.4, 0.4);
        const double amplitude = random.between(-1, 1), phase = random.between(0, 2 * M_PI);
        waves.push_back({frequency, amplitude, phase});
    }
    return [waves](const Vector& x) {
        double sum = 0;
        for (const Wave& w : waves)
            sum += w.amplitude * std::cos(dot(w.frequency, x) + w.phase);
        return sum;
    };
}

LevelSet random_level_set(Random& random, int kind)
{
    const Vector centre = random_vector(random, 0.3 * kVoxels, 0.7 * kVoxels), axis = random_direction(random);
    const double radius = random.between(0.15, 0.4) * kVoxels, tube = random.between(0.1, 0.2) * kVoxels;
    switch (kind) {
        case 0:
            return [=](const Vector& x) { return dot(axis, x - centre); };
        case 1:
            return [=](const Vector& x) { return radius - std::sqrt(dot(x - centre, x - centre)); };
        case 2:
            return [=](const Vector& x) {
                const Vector d = x - centre;
                const double along = dot(d, axis);
                const double around = std::sqrt(std::max(0.0, dot(d, d) - along * along)) - radius;
                return tube - std::hypot(around, along);
            };
        default:
            return random_waves(random);
    }
}

// Two indicators, f and -f.
void must(cleft_status status)
{
    if (status != CLEFT_OK)
        throw std::runtime_error(cleft_status_string(status));
}

cleft_volume* volume_of(cleft_context* context, const LevelSet& f)
{
    std::vector<float> inside, outside;
    for (int k = 0; k < kVoxels; ++k)
        for (int j = 0; j < kVoxels; ++j)
            for (int i = 0; i < kVoxels; ++i) {
                inside.push_back(static_cast<float>(f({i + 0.5, j + 0.5, k + 0.5})));
                outside.push_back(-inside.back());
            }
    const void* fields[2] = {outside.data(), inside.data()};
    const int64_t dims[3] = {kVoxels, kVoxels, kVoxels};
    cleft_volume* volume = nullptr;
    must(cleft_volume_create_indicators(context, CLEFT_TYPE_FLOAT32, fields, 2, dims, nullptr, nullptr, &volume));
    return volume;
}

// Of tetrahedra whose corners are all further than `margin` from the walls.
struct Angles {
    double least = 180, greatest = 0;
    int64_t tets = 0;

    void add(const cleft_mesh* mesh, double margin)
    {
        const double* points = cleft_mesh_points(mesh);
        const int32_t* corners = cleft_mesh_tets(mesh);
        for (int64_t t = 0; t < cleft_mesh_tet_count(mesh); ++t, corners += 4) {
            Vector x[4];
            bool is_inside = true;
            for (int i = 0; i < 4; ++i) {
                const double* p = points + 3 * corners[i];
                x[i] = {p[0], p[1], p[2]};
                for (int axis = 0; axis < 3; ++axis)
                    is_inside = is_inside && p[axis] > margin && p[axis] < kVoxels - margin;
            }
            if (is_inside)
                add(x);
        }
    }

private:
    void add(const Vector (&x)[4])
    {
        ++tets;
        for (int i = 0; i < 4; ++i)
            for (int j = i + 1; j < 4; ++j) {
                const int k = i == 0 ? (j == 1 ? 2 : 1) : 0, l = 6 - i - j - k;
                const Vector edge = x[j] - x[i];
                const Vector a = cross(edge, x[k] - x[i]), b = cross(edge, x[l] - x[i]), both = cross(a, b);
                const double angle = std::atan2(std::sqrt(dot(both, both)), dot(a, b)) * 180 / M_PI;
                least = std::min(least, angle);
                greatest = std::max(greatest, angle);
            }
    }
};

// Meshes the level set without improving; false if that fails.
bool add_angles(const LevelSet& level_set, double size, int snap, Angles& angles)
{
    cleft_context* context = nullptr;
    cleft_options* options = nullptr;
    cleft_mesh* mesh = nullptr;
    must(cleft_context_create(&context));
    must(cleft_options_create(&options));
    must(cleft_options_set_integer(options, CLEFT_OPTION_BACKGROUND, CLEFT_BACKGROUND_LATTICE));
    must(cleft_options_set_integer(options, CLEFT_OPTION_SNAP, snap));
    must(cleft_options_set_integer(options, CLEFT_OPTION_IMPROVE, CLEFT_IMPROVE_OFF));
    must(cleft_options_set_real(options, CLEFT_OPTION_SIZE, size));
    cleft_volume* volume = volume_of(context, level_set);
    const bool ok = cleft_mesh_volume(context, volume, nullptr, nullptr, options, &mesh) == CLEFT_OK;
    if (ok)
        angles.add(mesh, 1.6 * size);
    cleft_mesh_destroy(mesh);
    cleft_volume_destroy(volume);
    cleft_options_destroy(options);
    cleft_context_destroy(context);
    return ok;
}

Angles angles_of_many(int snap, bool& ok)
{
    Random random(1);
    Angles angles;
    ok = true;
    for (int i = 0; i < kLevelSets; ++i) {
        const LevelSet level_set = random_level_set(random, i % 4);
        ok = add_angles(level_set, random.between(1.3, 3), snap, angles) && ok;
    }
    return angles;
}

void assert_within_the_bound(int snap)
{
    bool ok = false;
    const Angles angles = angles_of_many(snap, ok);
    assert_true(ok);
    assert_true(angles.tets > 100 * kLevelSets);
    print_message("%lld tetrahedra, %.2f to %.2f degrees\n", static_cast<long long>(angles.tets), angles.least,
                  angles.greatest);
    assert_true(angles.least >= kLeast);
    assert_true(angles.greatest <= kGreatest);
}

void snapping_by_quality_keeps_the_bound_of_isosurface_stuffing(void**) { assert_within_the_bound(CLEFT_SNAP_QUALITY); }

void safe_snapping_keeps_the_bound_of_isosurface_stuffing(void**) { assert_within_the_bound(CLEFT_SNAP_SAFE); }

// The bound is snapping's doing, and what is measured includes the thin pieces that it takes away.
void without_snapping_there_is_no_bound(void**)
{
    bool ok = false;
    const Angles angles = angles_of_many(CLEFT_SNAP_NONE, ok);
    assert_true(ok);
    assert_true(angles.least < 2);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(snapping_by_quality_keeps_the_bound_of_isosurface_stuffing),
        cmocka_unit_test(safe_snapping_keeps_the_bound_of_isosurface_stuffing),
        cmocka_unit_test(without_snapping_there_is_no_bound),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
