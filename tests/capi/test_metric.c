/* Sizing fields with a metric, through the C interface. */
#include "support/capi.h"
#include "support/warnings.h"

#include <math.h>
#include <string.h>

enum { N = 24, kVoxels = N * N * N };

static cleft_volume* ball(cleft_context* context, const double affine[12])
{
    const int64_t dims[3] = {N, N, N};
    int32_t* labels = ball_labels(N);
    cleft_volume* volume = NULL;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_INT32, labels, dims, affine, NULL, &volume));
    free(labels);
    return volume;
}

/* Flat elements in a layer about the middle plane: 8 along it, and 1 across, more away from it. */
static double* layered_metric(void)
{
    double* tensors = (double*)malloc(sizeof(double) * 6 * kVoxels);
    for (int v = 0; v < kVoxels; ++v) {
        const double across = 1 + 0.3 * fabs(v / (N * N) + 0.5 - N / 2), along = 4;
        const double m[6] = {1 / (along * along), 0, 0, 1 / (along * along), 0, 1 / (across * across)};
        memcpy(tensors + 6 * v, m, sizeof m);
    }
    return tensors;
}

static cleft_sizing* sizing_of(cleft_context* context, const cleft_volume* volume, const double* tensors)
{
    cleft_sizing* sizing = NULL;
    assert_ok(context, cleft_sizing_create_metric(context, volume, CLEFT_TYPE_FLOAT64, tensors, 0, NULL, &sizing));
    return sizing;
}

static void assert_same_mesh(const cleft_mesh* a, const cleft_mesh* b)
{
    const int64_t points = cleft_mesh_point_count(a), tets = cleft_mesh_tet_count(a);
    assert_int_equal(points, cleft_mesh_point_count(b));
    assert_int_equal(tets, cleft_mesh_tet_count(b));
    assert_memory_equal(cleft_mesh_points(a), cleft_mesh_points(b), sizeof(double) * 3 * (size_t)points);
    assert_memory_equal(cleft_mesh_tets(a), cleft_mesh_tets(b), sizeof(int32_t) * 4 * (size_t)tets);
}

/* Each tensor comes back in world units, whatever the axes of the volume are. */
static void metrics_come_back_as_they_were_given(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    /* Axes that are turned, one of them flipped, of spacings 2, 3 and 0.5. */
    const double affine[12] = {0, -3, 0, 5, 2, 0, 0, -7, 0, 0, -0.5, 1};
    cleft_volume* volume = ball(context, affine);
    double* tensors = (double*)malloc(sizeof(double) * 6 * kVoxels);
    for (int v = 0; v < kVoxels; ++v) {
        const double m[6] = {0.5 + 1e-4 * v, 0.1, -0.05, 0.7, 0.2, 1.5};
        memcpy(tensors + 6 * v, m, sizeof m);
    }
    cleft_sizing* sizing = sizing_of(context, volume, tensors);
    assert_int_equal(cleft_sizing_has_metric(sizing), 1);
    float* back = (float*)malloc(sizeof(float) * 6 * kVoxels);
    assert_int_equal(cleft_sizing_copy_metric(sizing, back, 6 * kVoxels - 1), CLEFT_ERROR_BUFFER);
    assert_int_equal(cleft_sizing_copy_metric(sizing, back, 6 * kVoxels), CLEFT_OK);
    for (int i = 0; i < 6 * kVoxels; ++i)
        assert_true(fabs(back[i] - tensors[i]) < 1e-5);
    /* The size of regular tetrahedra that are as large. */
    const double* m = tensors;
    const double determinant =
        m[0] * (m[3] * m[5] - m[4] * m[4]) - m[1] * (m[1] * m[5] - m[4] * m[2]) + m[2] * (m[1] * m[4] - m[3] * m[2]);
    assert_true(fabs(cleft_sizing_values(sizing)[0] - pow(determinant, -1.0 / 6)) < 1e-5);
    cleft_sizing_destroy(sizing);
    assert_ok(context, cleft_sizing_create_constant(context, volume, 3, &sizing));
    assert_int_equal(cleft_sizing_has_metric(sizing), 0);
    assert_int_equal(cleft_sizing_copy_metric(sizing, back, 6 * kVoxels), CLEFT_ERROR_ARGUMENT);
    assert_int_equal(cleft_sizing_has_metric(NULL), 0);
    cleft_sizing_destroy(sizing);
    free(back);
    free(tensors);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void assert_refused(cleft_context* context, const cleft_volume* volume, const double* tensors,
                           cleft_status status, const char* words)
{
    cleft_sizing* sizing = NULL;
    assert_int_equal(cleft_sizing_create_metric(context, volume, CLEFT_TYPE_FLOAT64, tensors, 0, NULL, &sizing),
                     status);
    assert_null(sizing);
    assert_non_null(strstr(cleft_context_last_error(context), words));
    assert_non_null(strstr(cleft_context_last_error(context), "the 3rd along x, the 2nd along y and the 1st along z"));
}

static void tensors_that_are_no_metrics_are_refused_by_voxel(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = ball(context, NULL);
    double* tensors = layered_metric();
    double* bad = tensors + 6 * (2 + N);
    /* Those of later voxels are not the ones that are named. */
    bad[6] = NAN;
    bad[0] = INFINITY;
    assert_refused(context, volume, tensors, CLEFT_ERROR_NOT_FINITE, "NaN or infinite");
    bad[0] = -1;
    assert_refused(context, volume, tensors, CLEFT_ERROR_ARGUMENT, "not positive definite");
    bad[0] = 1;
    bad[1] = bad[3] = 1; /* two directions of which one has no length */
    assert_refused(context, volume, tensors, CLEFT_ERROR_ARGUMENT, "not positive definite");
    bad[1] = 0;
    bad[3] = 1e-9; /* 31,623 times as long as the others */
    assert_refused(context, volume, tensors, CLEFT_ERROR_ARGUMENT, "10000 times");
    bad[0] = bad[3] = bad[5] = 1e-62;
    assert_refused(context, volume, tensors, CLEFT_ERROR_ARGUMENT, "asks for sizes");
    cleft_sizing* sizing = NULL;
    assert_fails(context, CLEFT_ERROR_ARGUMENT,
                 cleft_sizing_create_metric(context, volume, CLEFT_TYPE_INT32, tensors, 0, NULL, &sizing));
    const double flat[6] = {1, 0, 0, 1, 0, 0}, endless[6] = {1, 0, 0, NAN, 0, 1};
    assert_fails(context, CLEFT_ERROR_ARGUMENT, cleft_sizing_create_constant_metric(context, volume, flat, &sizing));
    assert_fails(context, CLEFT_ERROR_NOT_FINITE,
                 cleft_sizing_create_constant_metric(context, volume, endless, &sizing));
    free(tensors);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* The one call and the calls one by one give the same bytes, on one thread and on three. */
static void stages_go_on_in_the_metric(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = ball(context, NULL);
    double* tensors = layered_metric();
    cleft_sizing* sizing = sizing_of(context, volume, tensors);
    cleft_mesh *at_once = NULL, *background = NULL, *cleaved = NULL, *improved = NULL;
    assert_ok(context, cleft_mesh_volume(context, volume, sizing, NULL, NULL, &at_once));
    assert_ok(context, cleft_context_set_threads(context, 3));
    assert_ok(context, cleft_background_create(context, sizing, NULL, &background));
    assert_ok(context, cleft_mesh_cleave(context, volume, background, NULL, &cleaved));
    assert_ok(context, cleft_mesh_improve(context, volume, cleaved, NULL, &improved));
    assert_same_mesh(at_once, improved);
    cleft_mesh_destroy(improved);
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, background, NULL, &improved));
    assert_same_mesh(at_once, improved);
    cleft_mesh_destroy(improved);
    cleft_mesh_destroy(cleaved);
    cleft_mesh_destroy(background);
    cleft_mesh_destroy(at_once);
    cleft_sizing_destroy(sizing);
    free(tensors);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static double metric_of(const cleft_context* context, const char* wanted)
{
    for (int64_t i = 0; i < cleft_context_metric_count(context); ++i) {
        const char* name = NULL;
        double value = 0;
        assert_int_equal(cleft_context_metric(context, i, &name, &value), CLEFT_OK);
        if (strcmp(name, wanted) == 0)
            return value;
    }
    fail_msg("there is no metric %s", wanted);
    return 0;
}

/* Labels keep their volumes, the mesh is valid, and hardly any angle in the metric misses the goal. */
static void labels_are_kept_in_a_metric(void** state)
{
    (void)state;
    warnings reported;
    cleft_context* context = listening_context(&reported);
    cleft_volume* volume = ball(context, NULL);
    double* tensors = layered_metric();
    cleft_sizing* sizing = sizing_of(context, volume, tensors);
    cleft_mesh* mesh = NULL;
    assert_ok(context, cleft_mesh_volume(context, volume, sizing, NULL, NULL, &mesh));
    /* The goal is 25 degrees. Where a metric changes, a few may miss it, and are told. */
    assert_true(metric_of(context, "improving.tets_missed") < 10);
    assert_int_equal(reported.count, metric_of(context, "improving.tets_missed") > 0);
    cleft_validation validation = {.struct_size = sizeof validation};
    assert_ok(context, cleft_mesh_validate(context, mesh, 1, &validation));
    assert_int_equal(validation.valid, 1);
    assert_true(fabs(validation.volume - kVoxels) < 1e-6);
    cleft_report* report = NULL;
    assert_ok(context, cleft_report_create(context, volume, mesh, &report));
    for (int64_t i = 0; i < cleft_report_count(report); ++i) {
        cleft_label_report row = {.struct_size = sizeof row};
        assert_int_equal(cleft_report_label(report, i, &row), CLEFT_OK);
        assert_true(fabs(row.mesh_volume / row.voxel_volume - 1) < 0.01);
    }
    cleft_report_destroy(report);
    cleft_mesh_destroy(mesh);
    cleft_sizing_destroy(sizing);
    free(tensors);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* Least and greatest root of the eigenvalues of a metric whose axes are those of the world. */
static void sizes_of(const float* m, double sizes[3])
{
    sizes[0] = 1 / sqrt(m[0]);
    sizes[1] = 1 / sqrt(m[3]);
    sizes[2] = 1 / sqrt(m[5]);
}

static void options_bound_a_metric_in_every_direction(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = ball(context, NULL);
    double* tensors = layered_metric();
    cleft_options* options = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SIZE_MIN, 2), CLEFT_OK);
    assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SIZE_MAX, 3), CLEFT_OK);
    float* back = (float*)malloc(sizeof(float) * 6 * kVoxels);
    cleft_sizing* sizing = NULL;
    assert_ok(context, cleft_sizing_create_metric(context, volume, CLEFT_TYPE_FLOAT64, tensors, 0, options, &sizing));
    assert_int_equal(cleft_sizing_copy_metric(sizing, back, 6 * kVoxels), CLEFT_OK);
    for (int v = 0; v < kVoxels; ++v) {
        double sizes[3];
        sizes_of(back + 6 * v, sizes);
        const double across = 1 + 0.3 * fabs(v / (N * N) + 0.5 - N / 2);
        assert_true(fabs(sizes[0] - 3) < 1e-5 && fabs(sizes[1] - 3) < 1e-5);
        assert_true(fabs(sizes[2] - fmin(fmax(across, 2), 3)) < 1e-5);
    }
    cleft_sizing_destroy(sizing);
    cleft_options_destroy(options);
    free(back);
    free(tensors);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* With the computed field, no length is greater than that asks for. */
static void combined_metrics_are_no_coarser_than_features(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = ball(context, NULL);
    double* tensors = layered_metric();
    cleft_sizing *computed = NULL, *combined = NULL;
    assert_ok(context, cleft_sizing_create(context, volume, NULL, &computed));
    assert_ok(context, cleft_sizing_create_metric(context, volume, CLEFT_TYPE_FLOAT64, tensors, 1, NULL, &combined));
    float* back = (float*)malloc(sizeof(float) * 6 * kVoxels);
    assert_int_equal(cleft_sizing_copy_metric(combined, back, 6 * kVoxels), CLEFT_OK);
    for (int v = 0; v < kVoxels; ++v) {
        double sizes[3];
        sizes_of(back + 6 * v, sizes);
        const double feature = cleft_sizing_values(computed)[v];
        const double across = 1 + 0.3 * fabs(v / (N * N) + 0.5 - N / 2);
        assert_true(fabs(sizes[0] - fmin(4, feature)) < 1e-4 && fabs(sizes[2] - fmin(across, feature)) < 1e-4);
    }
    free(back);
    cleft_sizing_destroy(combined);
    cleft_sizing_destroy(computed);
    free(tensors);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void wanted_numbers_scale_a_metric(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = ball(context, NULL);
    double* tensors = layered_metric();
    cleft_options* options = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_TETS, 20000), CLEFT_OK);
    cleft_sizing* sizing = sizing_of(context, volume, tensors);
    cleft_mesh* mesh = NULL;
    assert_ok(context, cleft_mesh_volume(context, volume, sizing, NULL, options, &mesh));
    assert_true(llabs(cleft_mesh_tet_count(mesh) - 20000) < 2000);
    cleft_mesh_destroy(mesh);
    cleft_sizing_destroy(sizing);
    cleft_options_destroy(options);
    free(tensors);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void lattices_need_a_metric_of_the_voxels_axes(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = ball(context, NULL);
    double* tensors = layered_metric();
    cleft_options* options = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_BACKGROUND, CLEFT_BACKGROUND_OCTREE), CLEFT_OK);
    cleft_sizing* sizing = sizing_of(context, volume, tensors);
    cleft_mesh* mesh = NULL;
    assert_fails(context, CLEFT_ERROR_OPTION, cleft_mesh_volume(context, volume, sizing, NULL, options, &mesh));
    assert_non_null(strstr(cleft_context_last_error(context), "particles"));
    cleft_sizing_destroy(sizing);
    const double flat[6] = {1.0 / 9, 0, 0, 1.0 / 9, 0, 1};
    assert_ok(context, cleft_sizing_create_constant_metric(context, volume, flat, &sizing));
    assert_ok(context, cleft_mesh_volume(context, volume, sizing, NULL, options, &mesh));
    assert_true(cleft_mesh_tet_count(mesh) > 10000);
    cleft_mesh_destroy(mesh);
    cleft_sizing_destroy(sizing);
    cleft_options_destroy(options);
    free(tensors);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(metrics_come_back_as_they_were_given),
        cmocka_unit_test(tensors_that_are_no_metrics_are_refused_by_voxel),
        cmocka_unit_test(stages_go_on_in_the_metric),
        cmocka_unit_test(labels_are_kept_in_a_metric),
        cmocka_unit_test(options_bound_a_metric_in_every_direction),
        cmocka_unit_test(combined_metrics_are_no_coarser_than_features),
        cmocka_unit_test(wanted_numbers_scale_a_metric),
        cmocka_unit_test(lattices_need_a_metric_of_the_voxels_axes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
