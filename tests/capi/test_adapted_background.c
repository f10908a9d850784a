/* Backgrounds of users that are adapted to a metric, through the C interface. */
#include "support/capi.h"
#include "support/warnings.h"

#include <math.h>
#include <string.h>

enum { N = 16 };

typedef struct {
    warnings reported;
    cleft_context* context;
    cleft_options* options;
    cleft_volume* volume;
    cleft_sizing* metric;
} fixture;

static cleft_volume* volume_of(cleft_context* context, const int32_t* labels)
{
    const int64_t dims[3] = {N, N, N};
    cleft_volume* volume = NULL;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_INT32, labels, dims, NULL, NULL, &volume));
    return volume;
}

/* Flat elements about the middle plane, and round ones away from it. */
static int set_up(void** state)
{
    fixture* f = (fixture*)calloc(1, sizeof *f);
    f->context = listening_context(&f->reported);
    assert_int_equal(cleft_options_create(&f->options), CLEFT_OK);
    int32_t* labels = ball_labels(N);
    f->volume = volume_of(f->context, labels);
    free(labels);
    double* tensors = (double*)malloc(sizeof(double) * 6 * N * N * N);
    for (int v = 0; v < N * N * N; ++v) {
        const double across = fmin(4, 1 + 0.4 * fabs(v / (N * N) + 0.5 - N / 2));
        const double m[6] = {1.0 / 16, 0, 0, 1.0 / 16, 0, 1 / (across * across)};
        memcpy(tensors + 6 * v, m, sizeof m);
    }
    assert_ok(f->context,
              cleft_sizing_create_metric(f->context, f->volume, CLEFT_TYPE_FLOAT64, tensors, 0, NULL, &f->metric));
    free(tensors);
    *state = f;
    return 0;
}

static int tear_down(void** state)
{
    fixture* f = (fixture*)*state;
    cleft_sizing_destroy(f->metric);
    cleft_volume_destroy(f->volume);
    cleft_options_destroy(f->options);
    cleft_context_destroy(f->context);
    free(f);
    return 0;
}

/* A mesh of the box that has nothing to do with the metric, turned into one of the user. */
static cleft_mesh* lattice(const fixture* f, double size)
{
    cleft_options* options = NULL;
    cleft_sizing* sizing = NULL;
    cleft_mesh *made = NULL, *own = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_BACKGROUND, CLEFT_BACKGROUND_LATTICE), CLEFT_OK);
    assert_ok(f->context, cleft_sizing_create_constant(f->context, f->volume, size, &sizing));
    assert_ok(f->context, cleft_background_create(f->context, sizing, options, &made));
    assert_ok(f->context, cleft_mesh_create(f->context, cleft_mesh_point_count(made), cleft_mesh_points(made),
                                            cleft_mesh_tet_count(made), cleft_mesh_tets(made), NULL, 0, &own));
    cleft_mesh_destroy(made);
    cleft_sizing_destroy(sizing);
    cleft_options_destroy(options);
    return own;
}

static cleft_mesh* meshed(const fixture* f, const cleft_mesh* background)
{
    cleft_mesh* mesh = NULL;
    assert_ok(f->context, cleft_mesh_volume(f->context, f->volume, f->metric, background, f->options, &mesh));
    return mesh;
}

static void assert_meets_metric(const fixture* f, const cleft_mesh* mesh)
{
    cleft_metric_quality quality = {.struct_size = sizeof quality};
    assert_ok(f->context, cleft_mesh_metric_quality(f->context, mesh, f->metric, &quality));
    /* Cleaving puts points where interfaces are. */
    assert_true((double)quality.edges_in_range > 0.85 * (double)quality.edge_count);
    assert_true(quality.mean_ratio_least > 0.15);
    cleft_validation validation = {.struct_size = sizeof validation};
    assert_ok(f->context, cleft_mesh_validate(f->context, mesh, 1, &validation));
    assert_int_equal(validation.valid, 1);
    assert_true(fabs(validation.volume - N * N * N) < 1e-6);
}

/* Whatever the sizes of the background are: the box as twelve tetrahedra, and edges of half a voxel. */
static void backgrounds_of_any_size_follow_the_metric(void** state)
{
    fixture* f = (fixture*)*state;
    cleft_mesh* without = meshed(f, NULL);
    const double expected = (double)cleft_mesh_tet_count(without);
    for (double size = 16; size > 0.9; size /= 4) {
        cleft_mesh* background = lattice(f, size);
        cleft_mesh* mesh = meshed(f, background);
        assert_meets_metric(f, mesh);
        assert_true(fabs((double)cleft_mesh_tet_count(mesh) / expected - 1) < 0.15);
        cleft_mesh_destroy(mesh);
        cleft_mesh_destroy(background);
    }
    cleft_mesh_destroy(without);
}

static void threads_change_no_byte(void** state)
{
    fixture* f = (fixture*)*state;
    cleft_mesh* background = lattice(f, 3);
    cleft_mesh* one = meshed(f, background);
    assert_ok(f->context, cleft_context_set_threads(f->context, 3));
    cleft_mesh* three = meshed(f, background);
    assert_int_equal(cleft_mesh_point_count(one), cleft_mesh_point_count(three));
    assert_memory_equal(cleft_mesh_points(one), cleft_mesh_points(three),
                        sizeof(double) * 3 * (size_t)cleft_mesh_point_count(one));
    cleft_mesh_destroy(three);
    cleft_mesh_destroy(one);
    cleft_mesh_destroy(background);
}

/* A hull that is in no plane across an axis stays what it is: here an octahedron within the box. */
static void slanted_hulls_stay(void** state)
{
    fixture* f = (fixture*)*state;
    const double points[] = {8, 8, 8, 1, 8, 8, 15, 8, 8, 8, 1, 8, 8, 15, 8, 8, 8, 1, 8, 8, 15};
    int32_t tets[8 * 4];
    for (int octant = 0; octant < 8; ++octant) {
        const int x = octant & 1, y = octant >> 1 & 1, z = octant >> 2, odd = (x + y + z) % 2 == 0;
        const int32_t corners[4] = {0, 1 + x, odd ? 5 + z : 3 + y, odd ? 3 + y : 5 + z};
        memcpy(tets + 4 * octant, corners, sizeof corners);
    }
    cleft_mesh* background = NULL;
    assert_ok(f->context, cleft_mesh_create(f->context, 7, points, 8, tets, NULL, 0, &background));
    cleft_mesh* mesh = meshed(f, background);
    assert_true(cleft_mesh_tet_count(mesh) > 100);
    cleft_validation validation = {.struct_size = sizeof validation};
    assert_ok(f->context, cleft_mesh_validate(f->context, mesh, 0, &validation));
    assert_int_equal(validation.negative_tets + validation.flat_tets + validation.crowded_faces, 0);
    assert_true(fabs(validation.volume / (4.0 / 3 * 7 * 7 * 7) - 1) < 1e-9);
    cleft_mesh_destroy(mesh);
    cleft_mesh_destroy(background);
}

/* Without repair nothing changes a background but cleaving, which a volume of one label does not ask for. */
static void without_repair_backgrounds_stay(void** state)
{
    fixture* f = (fixture*)*state;
    cleft_volume_destroy(f->volume);
    int32_t* labels = (int32_t*)calloc((size_t)N * N * N, sizeof *labels);
    f->volume = volume_of(f->context, labels);
    free(labels);
    assert_int_equal(cleft_options_set_real(f->options, CLEFT_OPTION_REPAIR, 0), CLEFT_OK);
    assert_int_equal(cleft_options_set_integer(f->options, CLEFT_OPTION_IMPROVE, CLEFT_IMPROVE_OFF), CLEFT_OK);
    cleft_mesh* background = lattice(f, 3);
    cleft_mesh* mesh = meshed(f, background);
    assert_int_equal(cleft_mesh_tet_count(mesh), cleft_mesh_tet_count(background));
    assert_int_equal(cleft_mesh_point_count(mesh), cleft_mesh_point_count(background));
    cleft_mesh_destroy(mesh);
    cleft_mesh_destroy(background);
}

/* A field that changes nothing is told: sizes alone, and any field beside a background of the library. */
static void fields_without_effect_are_reported(void** state)
{
    fixture* f = (fixture*)*state;
    cleft_mesh *user = lattice(f, 3), *ours = NULL, *mesh = NULL;
    cleft_sizing* sizes = NULL;
    assert_ok(f->context, cleft_sizing_create_constant(f->context, f->volume, 3, &sizes));
    assert_ok(f->context, cleft_mesh_volume(f->context, f->volume, sizes, user, NULL, &mesh));
    assert_reported(&f->reported, "the sizing field has no effect on a background that is given");
    cleft_mesh_destroy(mesh);
    assert_ok(f->context, cleft_background_create(f->context, sizes, NULL, &ours));
    assert_ok(f->context, cleft_mesh_volume(f->context, f->volume, f->metric, ours, NULL, &mesh));
    assert_reported(&f->reported, "the sizing field has no effect on a background that is given");
    cleft_mesh_destroy(mesh);
    cleft_mesh_destroy(ours);
    cleft_mesh_destroy(user);
    cleft_sizing_destroy(sizes);
}

static void estimates_know_of_the_metric(void** state)
{
    fixture* f = (fixture*)*state;
    cleft_mesh* background = lattice(f, 8);
    cleft_estimate with = {.struct_size = sizeof with}, field = with;
    assert_ok(f->context, cleft_mesh_estimate(f->context, f->volume, f->metric, background, NULL, &with));
    assert_ok(f->context, cleft_mesh_estimate(f->context, f->volume, f->metric, NULL, NULL, &field));
    assert_true(with.tets == field.tets);
    cleft_mesh_destroy(background);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(backgrounds_of_any_size_follow_the_metric, set_up, tear_down),
        cmocka_unit_test_setup_teardown(threads_change_no_byte, set_up, tear_down),
        cmocka_unit_test_setup_teardown(slanted_hulls_stay, set_up, tear_down),
        cmocka_unit_test_setup_teardown(without_repair_backgrounds_stay, set_up, tear_down),
        cmocka_unit_test_setup_teardown(fields_without_effect_are_reported, set_up, tear_down),
        cmocka_unit_test_setup_teardown(estimates_know_of_the_metric, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
