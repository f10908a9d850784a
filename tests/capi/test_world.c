/* What is measured of a mesh is reported in the world, also where the affine shears, turns, mirrors or is far away. */
#include "support/capi.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { NX = 7, NY = 6, NZ = 5, VOXELS = NX * NY * NZ, CASES = 12 };

static uint32_t random_state = 11;

static double random_number(void)
{
    random_state = random_state * 1664525u + 1013904223u;
    return (double)(random_state >> 8) / 16777216.0;
}

static double determinant(const double a[12])
{
    return a[0] * (a[5] * a[10] - a[6] * a[9]) - a[1] * (a[4] * a[10] - a[6] * a[8]) +
           a[2] * (a[4] * a[9] - a[5] * a[8]);
}

/* Columns of lengths 0.5 to 2, at angles of 30 to 150 degrees or so, either way round. */
static void random_affine(double a[12])
{
    do {
        for (int i = 0; i < 12; ++i)
            a[i] = i % 4 == 3 ? 200 * random_number() - 100 : 3 * random_number() - 1.5;
    } while (fabs(determinant(a)) < 0.8);
}

static double area(const double* p, const double* q, const double* r)
{
    const double u[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]}, v[3] = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
    const double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
    return sqrt(x * x + y * y + z * z) / 2;
}

static double hull_area(cleft_context* context, const cleft_mesh* mesh)
{
    const double* points = cleft_mesh_points(mesh);
    cleft_surface* surface = NULL;
    double sum = 0;
    assert_ok(context, cleft_surface_create(context, mesh, &surface));
    const int32_t* corners = cleft_surface_hull_triangles(surface);
    for (int64_t t = 0; t < cleft_surface_hull_count(surface); ++t, corners += 3)
        sum += area(points + 3 * corners[0], points + 3 * corners[1], points + 3 * corners[2]);
    cleft_surface_destroy(surface);
    return sum;
}

/* The side of the box of voxels between two axes. */
static double side_area(const double a[12], int first, int second, int voxels)
{
    const double zero[3] = {0, 0, 0}, p[3] = {a[first], a[4 + first], a[8 + first]};
    const double q[3] = {a[second], a[4 + second], a[8 + second]};
    return 2 * area(zero, p, q) * voxels;
}

static void assert_near(double value, double expected)
{
    if (!(fabs(value - expected) <= 1e-9 * fabs(expected)))
        fail_msg("%.17g is not %.17g", value, expected);
}

static cleft_volume* noise_volume(cleft_context* context, const double affine[12])
{
    const int64_t dims[3] = {NX, NY, NZ};
    uint8_t voxels[VOXELS];
    cleft_volume* volume = NULL;
    for (int v = 0; v < VOXELS; ++v)
        voxels[v] = (uint8_t)(3 * random_number());
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, voxels, dims, affine, NULL, &volume));
    return volume;
}

static void assert_report(cleft_context* context, const cleft_volume* volume, const cleft_mesh* mesh, double voxel)
{
    cleft_report* report = NULL;
    double in_voxels = 0, in_mesh = 0;
    assert_ok(context, cleft_report_create(context, volume, mesh, &report));
    for (int64_t i = 0; i < cleft_report_count(report); ++i) {
        cleft_label_report row = {.struct_size = sizeof row};
        double volume_of_label = 0;
        assert_ok(context, cleft_report_label(report, i, &row));
        assert_near(row.voxel_volume, voxel * (double)row.voxels);
        for (int64_t t = 0; t < cleft_mesh_tet_count(mesh); ++t) {
            const double* p = cleft_mesh_points(mesh);
            const int32_t* c = cleft_mesh_tets(mesh) + 4 * t;
            const double *o = p + 3 * c[0], *x = p + 3 * c[1], *y = p + 3 * c[2], *z = p + 3 * c[3];
            const double m[12] = {x[0] - o[0], y[0] - o[0], z[0] - o[0], 0,           x[1] - o[1], y[1] - o[1],
                                  z[1] - o[1], 0,           x[2] - o[2], y[2] - o[2], z[2] - o[2]};
            volume_of_label += cleft_mesh_tet_labels(mesh)[t] == row.label ? determinant(m) / 6 : 0;
        }
        assert_near(row.mesh_volume, volume_of_label);
        in_voxels += row.voxel_volume;
        in_mesh += row.mesh_volume;
    }
    assert_near(in_voxels, voxel * VOXELS);
    assert_near(in_mesh, voxel * VOXELS);
    cleft_report_destroy(report);
}

static void volumes_and_areas_are_those_of_the_world(void** state)
{
    cleft_context* context = new_context();
    (void)state;
    for (int i = 0; i < CASES; ++i) {
        double affine[12];
        cleft_quality quality = {.struct_size = sizeof quality};
        cleft_validation found = {.struct_size = sizeof found};
        cleft_mesh* mesh = NULL;
        random_affine(affine);
        const double voxel = fabs(determinant(affine));
        const double sides =
            side_area(affine, 0, 1, NX * NY) + side_area(affine, 1, 2, NY * NZ) + side_area(affine, 2, 0, NZ * NX);
        cleft_volume* volume = noise_volume(context, affine);
        assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, NULL, &mesh));
        assert_report(context, volume, mesh, voxel);
        assert_ok(context, cleft_mesh_quality(context, mesh, &quality));
        assert_near(quality.total_volume, voxel * VOXELS);
        assert_ok(context, cleft_mesh_validate(context, mesh, 1, &found));
        assert_int_equal(found.valid, 1);
        assert_near(found.volume, voxel * VOXELS);
        assert_near(found.box_volume, voxel * VOXELS);
        assert_near(found.box_area, 2 * sides);
        assert_near(found.hull_area, hull_area(context, mesh));
        assert_near(found.hull_area, 2 * sides);
        cleft_mesh_destroy(mesh);
        cleft_volume_destroy(volume);
    }
    cleft_context_destroy(context);
}

static void places_of_faults_are_those_of_the_world(void** state)
{
    static const double affine[12] = {2, 1, 0, 1000, 0, 2, 0, -500, 0, 0, 2, 70};
    static const int32_t left_out[1] = {0};
    cleft_context* context = new_context();
    cleft_volume* volume = noise_volume(context, affine);
    cleft_options* options = NULL;
    cleft_mesh* mesh = NULL;
    cleft_validation found = {.struct_size = sizeof found};
    double x = 0, y = 0, z = 0;
    (void)state;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_strip(options, left_out, 1), CLEFT_OK);
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    assert_ok(context, cleft_mesh_validate(context, mesh, 1, &found));
    assert_int_equal(found.valid, 0);
    const char* place = strstr(cleft_context_last_error(context), "point at (");
    assert_non_null(place);
    assert_int_equal(sscanf(place, "point at (%lf, %lf, %lf)", &x, &y, &z), 3);
    assert_true(x > 990 && x < 1030 && y > -502 && y < -485 && z > 68 && z < 82);
    cleft_mesh_destroy(mesh);
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(volumes_and_areas_are_those_of_the_world),
        cmocka_unit_test(places_of_faults_are_those_of_the_world),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
