/* Triangles stay within surface_error of their interface, on shapes whose distance is known. */
#include "shapes.h"
#include "support/warnings.h"

enum { N = 64 };

static const scene kScene = {N, 26, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
static const double kError = 0.5;

static double torus(const scene* s, const double x[3])
{
    double middle[3];
    middle_of(s, middle);
    const double from_axis = hypot(x[0] - middle[0], x[1] - middle[1]);
    return 8 - hypot(from_axis - 19, x[2] - middle[2]);
}

static cleft_volume* labels_of(cleft_context* context, shape inside)
{
    const int64_t dims[3] = {N, N, N};
    uint8_t* labels = (uint8_t*)malloc(N * N * N);
    for (int v = 0; v < N * N * N; ++v) {
        const double x[3] = {v % N, v / N % N, v / N / N};
        labels[v] = inside(&kScene, x) > 0;
    }
    cleft_volume* volume = NULL;
    assert_ok(context,
              cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, labels, dims, kScene.affine, NULL, &volume));
    free(labels);
    return volume;
}

static cleft_mesh* mesh_of(cleft_context* context, const cleft_volume* volume, double error)
{
    cleft_options* options = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SURFACE_ERROR, error), CLEFT_OK);
    cleft_mesh* mesh = NULL;
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    cleft_options_destroy(options);
    return mesh;
}

/* Of the places of a grid in each triangle. */
static double greatest_distance(cleft_context* context, const cleft_mesh* mesh, shape exact)
{
    enum { STEPS = 6 };
    cleft_surface* surface = NULL;
    assert_ok(context, cleft_surface_create(context, mesh, &surface));
    const double* points = cleft_mesh_points(mesh);
    double greatest = 0;
    for (int64_t t = 0; t < cleft_surface_interface_count(surface); ++t) {
        const int32_t* corner = cleft_surface_interface_triangles(surface) + 3 * t;
        for (int i = 0; i <= STEPS; ++i)
            for (int j = 0; i + j <= STEPS; ++j) {
                const double u = (double)i / STEPS, v = (double)j / STEPS;
                double x[3];
                for (int axis = 0; axis < 3; ++axis)
                    x[axis] = (1 - u - v) * points[3 * corner[0] + axis] + u * points[3 * corner[1] + axis] +
                              v * points[3 * corner[2] + axis];
                greatest = fmax(greatest, fabs(exact(&kScene, x)));
            }
    }
    cleft_surface_destroy(surface);
    return greatest;
}

static void assert_within(shape exact, double most_of_fields, double most_of_labels)
{
    cleft_context* context = new_context();
    cleft_volume* volumes[2] = {volume_of_shapes(context, &kScene, &exact, 1), labels_of(context, exact)};
    for (int from_labels = 0; from_labels < 2; ++from_labels) {
        cleft_mesh* coarse = mesh_of(context, volumes[from_labels], 0);
        cleft_mesh* fine = mesh_of(context, volumes[from_labels], kError);
        assert_true(greatest_distance(context, coarse, exact) > 1);
        const double greatest = greatest_distance(context, fine, exact);
        if (greatest > (from_labels ? most_of_labels : most_of_fields))
            fail_msg("from %s: %g", from_labels ? "labels" : "functions", greatest);
        cleft_validation valid = {.struct_size = sizeof valid};
        assert_ok(context, cleft_mesh_validate(context, fine, 1, &valid));
        assert_true(valid.valid);
        cleft_quality quality = {.struct_size = sizeof quality};
        assert_ok(context, cleft_mesh_quality(context, fine, &quality));
        assert_true(quality.min_dihedral >= 25);
        cleft_mesh_destroy(coarse);
        cleft_mesh_destroy(fine);
        cleft_volume_destroy(volumes[from_labels]);
    }
    cleft_context_destroy(context);
}

/* The steps of the voxels alone are up to 0.45 of a voxel high. */
static void test_a_ball_is_within_the_error(void** state)
{
    (void)state;
    assert_within(ball, 1.1 * kError, 1.5 * kError);
}

static void test_a_torus_is_within_the_error(void** state)
{
    (void)state;
    assert_within(torus, 1.1 * kError, 1.5 * kError);
}

/* Three labels meet in a circle. */
static void test_lines_are_held_too(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    const shape shapes[] = {outside_ball, upper_half, lower_half};
    cleft_volume* volume = volume_of_shapes(context, &kScene, shapes, 3);
    double mean[2];
    for (int with = 0; with < 2; ++with) {
        cleft_mesh* mesh = mesh_of(context, volume, with ? kError : 0);
        cleft_report* report = NULL;
        assert_ok(context, cleft_report_create_with_distances(context, volume, mesh, &report));
        assert_int_equal(cleft_report_distance_count(report), 4);
        cleft_distance line = {.struct_size = sizeof line};
        assert_int_equal(cleft_report_distance(report, 3, &line), CLEFT_OK);
        assert_true(line.is_line);
        mean[with] = line.mesh_mean;
        if (with)
            assert_true(line.mesh_greatest < 2 * kError);
        cleft_report_destroy(report);
        cleft_mesh_destroy(mesh);
    }
    assert_true(mean[1] < 0.7 * mean[0]);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void test_a_flat_interface_needs_no_more(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    const shape shapes[] = {plane};
    cleft_volume* volume = volume_of_shapes(context, &kScene, shapes, 1);
    cleft_mesh *without = mesh_of(context, volume, 0), *with = mesh_of(context, volume, kError);
    assert_int_equal(cleft_mesh_tet_count(without), cleft_mesh_tet_count(with));
    cleft_mesh_destroy(without);
    cleft_mesh_destroy(with);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void test_what_is_no_error_is_refused(void** state)
{
    (void)state;
    cleft_options* options = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SURFACE_ERROR, -0.5), CLEFT_ERROR_OPTION);
    assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SURFACE_ERROR, NAN), CLEFT_ERROR_NOT_FINITE);
    assert_int_equal(cleft_options_set_text(options, "surface-error", "much"), CLEFT_ERROR_OPTION);
    assert_int_equal(cleft_options_set_text(options, "surface-error", "0.25"), CLEFT_OK);
    cleft_options_destroy(options);
}

static void assert_same_points(const cleft_mesh* a, const cleft_mesh* b)
{
    const int64_t count = cleft_mesh_point_count(a);
    assert_int_equal(count, cleft_mesh_point_count(b));
    assert_memory_equal(cleft_mesh_points(a), cleft_mesh_points(b), (size_t)(3 * count) * sizeof(double));
}

static void test_the_default_is_half_a_voxel(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = labels_of(context, ball);
    cleft_mesh *by_default = NULL, *minus_one = mesh_of(context, volume, -1), *half = mesh_of(context, volume, 0.5);
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, NULL, &by_default));
    assert_same_points(by_default, half);
    assert_same_points(minus_one, half);
    cleft_mesh_destroy(by_default);
    cleft_mesh_destroy(minus_one);
    cleft_mesh_destroy(half);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* Nearly all edges of a ball of radius 26 are far off at edge length 12. */
static void test_sizes_for_something_else_are_kept(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = labels_of(context, ball);
    cleft_mesh* meshes[2] = {NULL, NULL};
    for (int with = 0; with < 2; ++with) {
        cleft_options* options = NULL;
        assert_int_equal(cleft_options_create(&options), CLEFT_OK);
        assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SIZE, 12), CLEFT_OK);
        assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SURFACE_ERROR, with * kError), CLEFT_OK);
        assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &meshes[with]));
        cleft_options_destroy(options);
    }
    assert_int_equal(cleft_mesh_tet_count(meshes[0]), cleft_mesh_tet_count(meshes[1]));
    cleft_mesh_destroy(meshes[0]);
    cleft_mesh_destroy(meshes[1]);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void test_threads_do_not_matter(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = labels_of(context, torus);
    cleft_mesh* meshes[2];
    for (int i = 0; i < 2; ++i) {
        assert_ok(context, cleft_context_set_threads(context, 1 + 3 * i));
        meshes[i] = mesh_of(context, volume, kError);
    }
    assert_same_points(meshes[0], meshes[1]);
    cleft_mesh_destroy(meshes[0]);
    cleft_mesh_destroy(meshes[1]);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* Sizes that are given leave no room for an error. A default is not reported, and what is asked for is. */
static void test_an_error_without_effect_is_reported(void** state)
{
    (void)state;
    warnings reported;
    cleft_context* context = listening_context(&reported);
    cleft_volume* volume = labels_of(context, ball);
    cleft_options* options = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SIZE, 6), CLEFT_OK);
    for (int asked = 0; asked < 2; ++asked) {
        if (asked)
            assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SURFACE_ERROR, 0.05), CLEFT_OK);
        cleft_mesh* mesh = NULL;
        assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
        assert_reported(&reported, asked ? "surface_error 0.05 has no effect" : NULL);
        cleft_mesh_destroy(mesh);
    }
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_ball_is_within_the_error),
        cmocka_unit_test(test_a_torus_is_within_the_error),
        cmocka_unit_test(test_lines_are_held_too),
        cmocka_unit_test(test_a_flat_interface_needs_no_more),
        cmocka_unit_test(test_what_is_no_error_is_refused),
        cmocka_unit_test(test_threads_do_not_matter),
        cmocka_unit_test(test_the_default_is_half_a_voxel),
        cmocka_unit_test(test_sizes_for_something_else_are_kept),
        cmocka_unit_test(test_an_error_without_effect_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
