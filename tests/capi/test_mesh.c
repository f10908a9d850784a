/* Meshes as arrays: in, out, checked, turned to ten nodes. */
#include "support/capi.h"

#include <math.h>
#include <string.h>

static const double kPoints[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
static const int32_t kTets[8] = {0, 1, 2, 3, 1, 2, 3, 4};
static const int32_t kLabels[2] = {-5, 70000};

static cleft_mesh* two_tets(cleft_context* context)
{
    cleft_mesh* mesh = NULL;
    assert_ok(context, cleft_mesh_create(context, 5, kPoints, 2, kTets, kLabels, 0, &mesh));
    return mesh;
}

static void arrays_come_out_as_they_went_in(void** state)
{
    cleft_context* context = new_context();
    cleft_mesh* mesh = two_tets(context);
    double points[15];
    int32_t tets[8], labels[2];
    (void)state;
    assert_int_equal(cleft_mesh_point_count(mesh), 5);
    assert_int_equal(cleft_mesh_tet_count(mesh), 2);
    assert_memory_equal(cleft_mesh_points(mesh), kPoints, sizeof kPoints);
    assert_memory_equal(cleft_mesh_tets(mesh), kTets, sizeof kTets);
    assert_memory_equal(cleft_mesh_tet_labels(mesh), kLabels, sizeof kLabels);
    assert_int_equal(cleft_mesh_label_count(mesh), 2);
    assert_int_equal(cleft_mesh_labels(mesh)[0], -5);
    assert_int_equal(cleft_mesh_labels(mesh)[1], 70000);
    assert_ok(context, cleft_mesh_copy_points(mesh, points, 15));
    assert_memory_equal(points, kPoints, sizeof points);
    assert_ok(context, cleft_mesh_copy_tets(mesh, 1, tets, 8));
    for (int i = 0; i < 8; ++i)
        assert_int_equal(tets[i], kTets[i] + 1);
    assert_ok(context, cleft_mesh_copy_tet_labels(mesh, labels, 2));
    assert_memory_equal(labels, kLabels, sizeof labels);
    assert_int_equal(cleft_mesh_copy_points(mesh, points, 14), CLEFT_ERROR_BUFFER);
    assert_int_equal(cleft_mesh_copy_tets(mesh, 0, tets, 7), CLEFT_ERROR_BUFFER);
    assert_int_equal(cleft_mesh_copy_tets(mesh, 2, tets, 8), CLEFT_ERROR_ARGUMENT);
    assert_int_equal(cleft_mesh_copy_tet_labels(mesh, NULL, 2), CLEFT_ERROR_NULL);
    cleft_mesh_destroy(mesh);
    cleft_context_destroy(context);
}

static void mistakes_are_named(void** state)
{
    cleft_context* context = new_context();
    double points[15];
    int32_t tets[8];
    cleft_mesh* mesh = NULL;
    (void)state;
    memcpy(points, kPoints, sizeof points);
    memcpy(tets, kTets, sizeof tets);
    tets[6] = 5;
    assert_fails(context, CLEFT_ERROR_ARGUMENT, cleft_mesh_create(context, 5, points, 2, tets, NULL, 0, &mesh));
    assert_non_null(strstr(cleft_context_last_error(context), "the 2nd tetrahedron"));
    assert_fails(context, CLEFT_ERROR_ARGUMENT, cleft_mesh_create(context, 5, points, 2, kTets, NULL, 1, &mesh));
    points[4] = INFINITY;
    assert_fails(context, CLEFT_ERROR_NOT_FINITE, cleft_mesh_create(context, 5, points, 2, kTets, NULL, 0, &mesh));
    assert_non_null(strstr(cleft_context_last_error(context), "the 2nd point"));
    assert_fails(context, CLEFT_ERROR_NULL, cleft_mesh_create(context, 5, NULL, 2, kTets, NULL, 0, &mesh));
    assert_fails(context, CLEFT_ERROR_ARGUMENT, cleft_mesh_create(context, -1, kPoints, 2, kTets, NULL, 0, &mesh));
    assert_fails(context, CLEFT_ERROR_TOO_LARGE,
                 cleft_mesh_create(context, (int64_t)1 << 40, kPoints, 2, kTets, NULL, 0, &mesh));
    assert_null(mesh);
    cleft_context_destroy(context);
}

static void an_empty_mesh_has_no_arrays(void** state)
{
    cleft_context* context = new_context();
    cleft_mesh* mesh = NULL;
    (void)state;
    assert_ok(context, cleft_mesh_create(context, 0, NULL, 0, NULL, NULL, 0, &mesh));
    assert_null(cleft_mesh_points(mesh));
    assert_null(cleft_mesh_tets(mesh));
    assert_null(cleft_mesh_tet_labels(mesh));
    assert_int_equal(cleft_mesh_label_count(mesh), 0);
    cleft_mesh_destroy(mesh);
    cleft_context_destroy(context);
}

static void quality_and_faults_are_told(void** state)
{
    cleft_context* context = new_context();
    cleft_mesh* mesh = two_tets(context);
    cleft_quality quality = {.struct_size = sizeof quality};
    cleft_validation found = {.struct_size = sizeof found};
    const int32_t turned[8] = {0, 1, 2, 3, 1, 3, 2, 4};
    (void)state;
    assert_ok(context, cleft_mesh_quality(context, mesh, &quality));
    assert_int_equal(quality.tet_count, 2);
    assert_true(fabs(quality.total_volume - 0.5) < 1e-14);
    assert_true(quality.min_dihedral > 50 && quality.max_dihedral < 91);
    assert_ok(context, cleft_mesh_validate(context, mesh, 0, &found));
    assert_int_equal(found.valid, 1);
    assert_string_equal(cleft_context_last_error(context), "");
    assert_ok(context, cleft_mesh_validate(context, mesh, 1, &found)); /* it does not fill its box */
    assert_int_equal(found.valid, 0);
    assert_true(cleft_context_last_error(context)[0] != '\0');
    cleft_mesh_destroy(mesh);
    assert_ok(context, cleft_mesh_create(context, 5, kPoints, 2, turned, NULL, 0, &mesh));
    assert_ok(context, cleft_mesh_validate(context, mesh, 0, &found));
    assert_int_equal(found.valid, 0);
    assert_int_equal(found.negative_tets, 1);
    cleft_mesh_destroy(mesh);
    quality.struct_size = 8;
    assert_int_equal(cleft_mesh_quality(context, mesh = two_tets(context), &quality), CLEFT_ERROR_ARGUMENT);
    cleft_mesh_destroy(mesh);
    cleft_context_destroy(context);
}

static void surfaces_point_from_the_first_label_to_the_second(void** state)
{
    cleft_context* context = new_context();
    cleft_mesh* mesh = two_tets(context);
    cleft_surface* surface = NULL;
    (void)state;
    assert_ok(context, cleft_surface_create(context, mesh, &surface));
    assert_int_equal(cleft_surface_interface_count(surface), 1);
    assert_int_equal(cleft_surface_interface_labels(surface)[0], -5);
    assert_int_equal(cleft_surface_interface_labels(surface)[1], 70000);
    const int32_t* t = cleft_surface_interface_triangles(surface);
    const double* a = kPoints + 3 * t[0];
    const double* b = kPoints + 3 * t[1];
    const double* c = kPoints + 3 * t[2];
    /* label -5 holds the origin: the normal must look away from it */
    const double n[3] = {(b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]),
                         (b[2] - a[2]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[2] - a[2]),
                         (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])};
    assert_true(n[0] * a[0] + n[1] * a[1] + n[2] * a[2] > 0);
    assert_int_equal(cleft_surface_hull_count(surface), 6);
    int sides[7] = {0};
    for (int i = 0; i < 6; ++i)
        ++sides[cleft_surface_hull_sides(surface)[i]];
    assert_int_equal(sides[CLEFT_SIDE_X_MIN], 1);
    assert_int_equal(sides[CLEFT_SIDE_Y_MIN], 1);
    assert_int_equal(sides[CLEFT_SIDE_Z_MIN], 1);
    assert_int_equal(sides[CLEFT_SIDE_OTHER], 3);
    cleft_surface_destroy(surface);
    cleft_mesh_destroy(mesh);
    cleft_context_destroy(context);
}

static void ten_nodes_share_their_middles(void** state)
{
    static const int kMiddles[6][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}};
    cleft_context* context = new_context();
    cleft_mesh* mesh = two_tets(context);
    int64_t count = 0;
    double points[3 * 14];
    int32_t tets[20];
    (void)state;
    assert_ok(context, cleft_mesh_copy_quadratic(mesh, 0, NULL, 0, NULL, 0, &count));
    assert_int_equal(count, 5 + 9); /* two tetrahedra that share a face have nine edges */
    assert_ok(context, cleft_mesh_copy_quadratic(mesh, 0, points, 3 * 14, tets, 20, &count));
    for (int t = 0; t < 2; ++t)
        for (int e = 0; e < 6; ++e)
            for (int axis = 0; axis < 3; ++axis) {
                const double* a = points + 3 * tets[10 * t + kMiddles[e][0]];
                const double* b = points + 3 * tets[10 * t + kMiddles[e][1]];
                assert_true(points[3 * tets[10 * t + 4 + e] + axis] == 0.5 * (a[axis] + b[axis]));
            }
    /* a failure writes nothing */
    count = -1;
    points[0] = -1e6;
    assert_int_equal(cleft_mesh_copy_quadratic(mesh, 0, points, 3 * 14 - 1, tets, 20, &count), CLEFT_ERROR_BUFFER);
    assert_int_equal(cleft_mesh_copy_quadratic(mesh, 0, points, 3 * 14, NULL, 20, &count), CLEFT_ERROR_NULL);
    assert_int_equal(cleft_mesh_copy_quadratic(mesh, 0, NULL, 3 * 14, tets, 20, &count), CLEFT_ERROR_NULL);
    assert_true(count == -1 && points[0] == -1e6);
    cleft_mesh_destroy(mesh);
    cleft_context_destroy(context);
}

/* rand() is one sequence of the whole program. */
static void the_random_numbers_of_the_program_go_on(void** state)
{
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, 12);
    cleft_mesh* mesh = NULL;
    int expected[4];
    (void)state;
    srand(7);
    for (int i = 0; i < 4; ++i)
        expected[i] = rand();
    srand(7);
    assert_int_equal(rand(), expected[0]);
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, NULL, &mesh));
    for (int i = 1; i < 4; ++i)
        assert_int_equal(rand(), expected[i]);
    cleft_mesh_destroy(mesh);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arrays_come_out_as_they_went_in),
        cmocka_unit_test(mistakes_are_named),
        cmocka_unit_test(an_empty_mesh_has_no_arrays),
        cmocka_unit_test(quality_and_faults_are_told),
        cmocka_unit_test(surfaces_point_from_the_first_label_to_the_second),
        cmocka_unit_test(ten_nodes_share_their_middles),
        cmocka_unit_test(the_random_numbers_of_the_program_go_on),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
