/* Distances of interfaces, against shapes whose distance is known. */
#include "shapes.h"

#include <stdio.h>
#include <string.h>

/* Voxels are twice as large as a unit and mirrored, so that distances must be those of the world. */
static const scene kScene = {40, 13, {-2, 0, 0, 7, 0, 2, 0, 3, 0, 0, 2, 1}};

static cleft_mesh* mesh_of(cleft_context* context, const cleft_volume* volume, double size)
{
    cleft_options* options = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SIZE, size), CLEFT_OK);
    cleft_mesh* mesh = NULL;
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    cleft_options_destroy(options);
    return mesh;
}

static cleft_distance distance_at(const cleft_report* report, int64_t index)
{
    cleft_distance row = {.struct_size = sizeof(cleft_distance)};
    assert_int_equal(cleft_report_distance(report, index, &row), CLEFT_OK);
    return row;
}

/* Of the corners, the middles of edges and the centroids of all triangles, in the world. */
static double greatest_from_ball(cleft_context* context, const cleft_mesh* mesh)
{
    double middle[3];
    middle_of(&kScene, middle);
    for (int axis = 0; axis < 3; ++axis)
        middle[axis] = kScene.affine[5 * axis] * middle[axis] + kScene.affine[4 * axis + 3];
    cleft_surface* surface = NULL;
    assert_ok(context, cleft_surface_create(context, mesh, &surface));
    const double* points = cleft_mesh_points(mesh);
    double greatest = 0;
    for (int64_t t = 0; t < cleft_surface_interface_count(surface); ++t) {
        const int32_t* corner = cleft_surface_interface_triangles(surface) + 3 * t;
        const int kPlaces[7][3] = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0, 0, 1}, {1, 1, 2}, {2, 2, 0}, {0, 1, 2}};
        for (int place = 0; place < 7; ++place) {
            double x[3] = {0, 0, 0};
            for (int axis = 0; axis < 3; ++axis) {
                const double a = points[3 * corner[kPlaces[place][0]] + axis],
                             b = points[3 * corner[kPlaces[place][1]] + axis],
                             c = points[3 * corner[kPlaces[place][2]] + axis];
                x[axis] = place < 6 ? 0.5 * (a + c) : (a + b + c) / 3;
            }
            greatest = fmax(greatest, fabs(distance_between(x, middle) - 2 * kScene.radius));
        }
    }
    cleft_surface_destroy(surface);
    return greatest;
}

static void test_distances_from_a_ball_are_those_of_its_radius(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    const shape shapes[] = {ball};
    cleft_volume* volume = volume_of_shapes(context, &kScene, shapes, 1);
    cleft_mesh* mesh = mesh_of(context, volume, 12);
    cleft_report* report = NULL;
    assert_ok(context, cleft_report_create_with_distances(context, volume, mesh, &report));
    assert_int_equal(cleft_report_distance_count(report), 1);
    const cleft_distance row = distance_at(report, 0);
    assert_int_equal(row.first, 0);
    assert_int_equal(row.second, 1);
    assert_int_equal(row.third, 1);
    assert_int_equal(row.is_line, 0);
    /* Between the voxels the function is interpolated, and searches end at a hundredth of a voxel. */
    const double expected = greatest_from_ball(context, mesh);
    assert_true(fabs(row.mesh_greatest - expected) < 0.05);
    assert_true(row.mesh_mean < row.mesh_99 && row.mesh_99 <= row.mesh_greatest);
    assert_true(expected > 0.4 && row.mesh_mean > 0.05); /* the mesh is coarse */
    assert_true(row.volume_mean < row.volume_99 && row.volume_99 <= row.volume_greatest);
    assert_true(row.volume_greatest <= row.mesh_greatest + 0.05);
    /* A crossing about every half of a voxel. */
    assert_true(row.points > 3000 && row.points < 6000);
    cleft_report_destroy(report);
    cleft_mesh_destroy(mesh);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void test_lines_come_after_interfaces(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    const shape shapes[] = {outside_ball, upper_half, lower_half};
    cleft_volume* volume = volume_of_shapes(context, &kScene, shapes, 3);
    cleft_mesh* mesh = mesh_of(context, volume, 6);
    cleft_report* report = NULL;
    assert_ok(context, cleft_report_create_with_distances(context, volume, mesh, &report));
    assert_int_equal(cleft_report_distance_count(report), 4);
    const int32_t kPairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};
    int64_t triangles = 0;
    for (int i = 0; i < 3; ++i) {
        const cleft_distance row = distance_at(report, i);
        assert_true(row.first == kPairs[i][0] && row.second == kPairs[i][1] && !row.is_line);
        triangles += row.elements;
    }
    cleft_surface* surface = NULL;
    assert_ok(context, cleft_surface_create(context, mesh, &surface));
    assert_int_equal(triangles, cleft_surface_interface_count(surface));
    cleft_surface_destroy(surface);
    const cleft_distance line = distance_at(report, 3);
    assert_true(line.is_line && line.first == 0 && line.second == 1 && line.third == 2);
    /* The circle has 163 units. */
    assert_true(line.elements > 15 && line.points > 60);
    assert_true(line.mesh_greatest < 6 && line.volume_greatest < 6);
    cleft_report_destroy(report);
    cleft_mesh_destroy(mesh);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void test_threads_do_not_matter(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, 30);
    cleft_mesh* mesh = mesh_of(context, volume, 4);
    cleft_distance first[8];
    for (int threads = 1; threads <= 4; threads += 3) {
        assert_ok(context, cleft_context_set_threads(context, threads));
        cleft_report* report = NULL;
        assert_ok(context, cleft_report_create_with_distances(context, volume, mesh, &report));
        assert_int_equal(cleft_report_distance_count(report), 4);
        for (int i = 0; i < 4; ++i) {
            const cleft_distance row = distance_at(report, i);
            if (threads == 1)
                first[i] = row;
            else
                assert_memory_equal(&row, &first[i], sizeof row);
        }
        /* Labels ascend, as users call them. */
        assert_int_equal(first[0].first, -3);
        assert_int_equal(first[0].second, 7);
        assert_int_equal(first[3].third, 1000);
        cleft_report_destroy(report);
    }
    cleft_mesh_destroy(mesh);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void test_a_plain_report_has_none(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, 20);
    cleft_mesh* mesh = mesh_of(context, volume, 4);
    cleft_report* report = NULL;
    assert_ok(context, cleft_report_create(context, volume, mesh, &report));
    assert_int_equal(cleft_report_distance_count(report), 0);
    assert_int_equal(cleft_report_distance_count(NULL), 0);
    cleft_distance row = {.struct_size = sizeof(cleft_distance)};
    assert_int_equal(cleft_report_distance(report, 0, &row), CLEFT_ERROR_ARGUMENT);
    assert_int_equal(cleft_report_distance(report, 0, NULL), CLEFT_ERROR_NULL);
    cleft_report* none = NULL;
    assert_fails(context, CLEFT_ERROR_NULL, cleft_report_create_with_distances(context, NULL, mesh, &none));
    cleft_report_destroy(report);
    cleft_mesh_destroy(mesh);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_distances_from_a_ball_are_those_of_its_radius),
        cmocka_unit_test(test_lines_come_after_interfaces),
        cmocka_unit_test(test_threads_do_not_matter),
        cmocka_unit_test(test_a_plain_report_has_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
