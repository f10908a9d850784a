/* Every stage alone, then all of them in one call. */
#include "support/capi.h"

#include <math.h>
#include <string.h>

enum { N = 20 };

static cleft_options* coarse(void)
{
    cleft_options* options = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SIZE_MIN, 2), CLEFT_OK);
    return options;
}

static void assert_sound(cleft_context* context, const cleft_mesh* mesh, double volume)
{
    cleft_validation found = {.struct_size = sizeof found};
    assert_ok(context, cleft_mesh_validate(context, mesh, 1, &found));
    if (!found.valid)
        fail_msg("%s", cleft_context_last_error(context));
    assert_true(fabs(found.volume - volume) <= 1e-9 * volume);
}

static void sizing_is_computed_constant_or_the_users(void** state)
{
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, N);
    cleft_options* options = coarse();
    cleft_sizing *computed = NULL, *constant = NULL, *own = NULL, *both = NULL;
    float* values = (float*)malloc(sizeof(float) * N * N * N);
    const double middle[3] = {N / 2.0, N / 2.0, N / 2.0}, bad_point[3] = {0, NAN, 0};
    double size = 0;
    int64_t dims[3];
    (void)state;
    assert_ok(context, cleft_sizing_create(context, volume, options, &computed));
    assert_ok(context, cleft_sizing_create_constant(context, volume, 2.5, &constant));
    for (int i = 0; i < N * N * N; ++i)
        values[i] = 3;
    assert_ok(context, cleft_sizing_create_values(context, volume, CLEFT_TYPE_FLOAT32, values, 0, NULL, &own));
    assert_ok(context, cleft_sizing_create_values(context, volume, CLEFT_TYPE_FLOAT32, values, 1, options, &both));
    assert_ok(context, cleft_sizing_dims(computed, dims));
    assert_int_equal(dims[1], N);
    assert_ok(context, cleft_sizing_at(constant, middle, &size));
    assert_true(fabs(size - 2.5) < 1e-6);
    assert_ok(context, cleft_sizing_at(own, middle, &size));
    assert_true(fabs(size - 3) < 1e-6);
    assert_int_equal(cleft_sizing_at(own, bad_point, &size), CLEFT_ERROR_NOT_FINITE);
    for (int i = 0; i < N * N * N; ++i) {
        assert_true(cleft_sizing_values(computed)[i] >= 2 - 1e-6f);
        assert_true(cleft_sizing_values(both)[i] <= 3 + 1e-6f);
        assert_true(cleft_sizing_values(both)[i] <= cleft_sizing_values(computed)[i] + 1e-6f);
    }
    assert_true(cleft_sizing_expected_tets(constant) > cleft_sizing_expected_tets(own));
    assert_true(cleft_sizing_expected_tets(NULL) == 0);
    cleft_sizing_destroy(both);
    both = NULL;
    for (int combine = 0; combine < 2; ++combine) {
        values[5] = -1;
        assert_fails(context, CLEFT_ERROR_ARGUMENT,
                     cleft_sizing_create_values(context, volume, CLEFT_TYPE_FLOAT32, values, combine, NULL, &both));
        assert_non_null(strstr(cleft_context_last_error(context), "is -1; it must be within 1e-30 to 1e+30"));
        values[5] = INFINITY;
        assert_fails(context, CLEFT_ERROR_NOT_FINITE,
                     cleft_sizing_create_values(context, volume, CLEFT_TYPE_FLOAT32, values, combine, NULL, &both));
    }
    assert_fails(context, CLEFT_ERROR_NOT_FINITE, cleft_sizing_create_constant(context, volume, INFINITY, &both));
    assert_fails(context, CLEFT_ERROR_ARGUMENT, cleft_sizing_create_constant(context, volume, -0.25, &both));
    assert_string_equal(cleft_context_last_error(context), "the size is -0.25; it must be within 1e-30 to 1e+30");
    assert_null(both);
    assert_fails(context, CLEFT_ERROR_ARGUMENT, cleft_sizing_create_constant(context, volume, 0, &both));
    free(values);
    cleft_sizing_destroy(own);
    cleft_sizing_destroy(constant);
    cleft_sizing_destroy(computed);
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void stages_one_by_one_give_a_sound_mesh(void** state)
{
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, N);
    cleft_sizing* sizing = NULL;
    cleft_mesh *background = NULL, *cleaved = NULL, *improved = NULL;
    cleft_report* report = NULL;
    (void)state;
    assert_ok(context, cleft_sizing_create_constant(context, volume, 2.2, &sizing));
    assert_ok(context, cleft_background_create(context, sizing, NULL, &background));
    assert_sound(context, background, N * N * N);
    assert_int_equal(cleft_mesh_label_count(background), 1);
    assert_int_equal(cleft_mesh_labels(background)[0], 0);
    assert_ok(context, cleft_mesh_cleave(context, volume, background, NULL, &cleaved));
    assert_sound(context, cleaved, N * N * N);
    assert_int_equal(cleft_mesh_label_count(cleaved), 3);
    assert_true(cleft_mesh_tet_count(cleaved) > cleft_mesh_tet_count(background));
    assert_ok(context, cleft_mesh_improve(context, volume, cleaved, NULL, &improved));
    assert_sound(context, improved, N * N * N);
    assert_ok(context, cleft_report_create(context, volume, improved, &report));
    assert_int_equal(cleft_report_count(report), 3);
    for (int64_t i = 0; i < 3; ++i) {
        cleft_label_report row = {.struct_size = sizeof row};
        assert_ok(context, cleft_report_label(report, i, &row));
        assert_int_equal(row.label, cleft_volume_labels(volume)[i]);
        assert_int_equal(row.lost, 0);
        assert_int_equal(row.voxel_components, 1);
        assert_int_equal(row.mesh_components, 1);
        assert_int_equal(row.large_components_lost, 0);
        assert_true(fabs(row.mesh_volume - row.voxel_volume) < 0.05 * row.voxel_volume);
    }
    cleft_label_report row = {.struct_size = sizeof row};
    assert_int_equal(cleft_report_label(report, 3, &row), CLEFT_ERROR_ARGUMENT);
    cleft_report_destroy(report);
    cleft_mesh_destroy(improved);
    cleft_mesh_destroy(cleaved);
    cleft_mesh_destroy(background);
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void one_call_gives_the_same_bytes_for_every_thread_count(void** state)
{
    cleft_context* context = new_context();
    cleft_options* options = coarse();
    cleft_mesh* mesh[3] = {NULL, NULL, NULL};
    (void)state;
    for (int t = 0; t < 3; ++t) {
        assert_ok(context, cleft_context_set_threads(context, t + 1));
        cleft_volume* volume = ball_volume(context, N);
        assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh[t]));
        cleft_volume_destroy(volume);
    }
    assert_sound(context, mesh[0], N * N * N);
    for (int t = 1; t < 3; ++t) {
        const size_t points = (size_t)cleft_mesh_point_count(mesh[0]), tets = (size_t)cleft_mesh_tet_count(mesh[0]);
        assert_int_equal(cleft_mesh_point_count(mesh[t]), points);
        assert_int_equal(cleft_mesh_tet_count(mesh[t]), tets);
        assert_memory_equal(cleft_mesh_points(mesh[t]), cleft_mesh_points(mesh[0]), 24 * points);
        assert_memory_equal(cleft_mesh_tets(mesh[t]), cleft_mesh_tets(mesh[0]), 16 * tets);
        assert_memory_equal(cleft_mesh_tet_labels(mesh[t]), cleft_mesh_tet_labels(mesh[0]), 4 * tets);
    }
    int64_t metrics = cleft_context_metric_count(context);
    assert_true(metrics > 5);
    const char* name = NULL;
    double value = -1;
    assert_ok(context, cleft_context_metric(context, metrics - 1, &name, &value));
    assert_non_null(name);
    /* a failure writes nothing */
    name = NULL;
    value = -1;
    assert_int_equal(cleft_context_metric(context, 0, &name, NULL), CLEFT_ERROR_NULL);
    assert_int_equal(cleft_context_metric(context, 0, NULL, &value), CLEFT_ERROR_NULL);
    assert_true(!name && value == -1);
    assert_ok(context, cleft_context_clear_metrics(context));
    assert_int_equal(cleft_context_metric_count(context), 0);
    for (int t = 0; t < 3; ++t)
        cleft_mesh_destroy(mesh[t]);
    cleft_options_destroy(options);
    cleft_context_destroy(context);
}

static void a_mirrored_world_still_has_positive_tetrahedra(void** state)
{
    const double affine[12] = {-1, 0, 0, 5, 0, 0, 2, 3, 0, -1.5, 0, 7};
    cleft_context* context = new_context();
    cleft_options* options = coarse();
    const int64_t dims[3] = {N, N, N};
    int32_t* labels = ball_labels(N);
    cleft_volume* volume = NULL;
    cleft_mesh* mesh = NULL;
    cleft_surface* surface = NULL;
    (void)state;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_INT32, labels, dims, affine, NULL, &volume));
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    assert_sound(context, mesh, N * N * N * 3.0);
    double lo = 1e300, hi = -1e300;
    for (int64_t i = 0; i < cleft_mesh_point_count(mesh); ++i) {
        lo = fmin(lo, cleft_mesh_points(mesh)[3 * i]);
        hi = fmax(hi, cleft_mesh_points(mesh)[3 * i]);
    }
    print_message("x from %.17g to %.17g\n", lo, hi);
    assert_true(lo == 5 - (N - 0.5) && hi == 5.5); /* the box ends where the voxels end */
    assert_ok(context, cleft_surface_create(context, mesh, &surface));
    double outward = 0;
    for (int64_t i = 0; i < cleft_surface_hull_count(surface); ++i) {
        const int32_t* t = cleft_surface_hull_triangles(surface) + 3 * i;
        const double* p[3];
        assert_int_not_equal(cleft_surface_hull_sides(surface)[i], CLEFT_SIDE_OTHER);
        for (int k = 0; k < 3; ++k)
            p[k] = cleft_mesh_points(mesh) + 3 * t[k];
        outward += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) -
                   p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
                   p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
    }
    assert_true(fabs(outward / 6 - N * N * N * 3.0) < 1e-6 * N * N * N); /* divergence theorem: wound outward */
    free(labels);
    cleft_surface_destroy(surface);
    cleft_mesh_destroy(mesh);
    cleft_volume_destroy(volume);
    cleft_options_destroy(options);
    cleft_context_destroy(context);
}

static void stripped_labels_are_gone_and_the_rest_stays(void** state)
{
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, N);
    cleft_options* options = coarse();
    const int32_t strip[1] = {1000}, only[1] = {7};
    cleft_mesh *all = NULL, *some = NULL, *ball = NULL;
    (void)state;
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &all));
    assert_ok(context, cleft_options_set_strip(options, strip, 1));
    assert_ok(context, cleft_mesh_strip(context, all, options, &some));
    assert_int_equal(cleft_mesh_label_count(some), 2);
    assert_int_equal(cleft_mesh_labels(some)[0], -3);
    assert_int_equal(cleft_mesh_labels(some)[1], 7);
    assert_ok(context, cleft_options_set_strip(options, NULL, 0));
    assert_ok(context, cleft_options_set_only(options, only, 1));
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &ball));
    assert_int_equal(cleft_mesh_label_count(ball), 1);
    cleft_validation found = {.struct_size = sizeof found};
    assert_ok(context, cleft_mesh_validate(context, ball, 0, &found));
    assert_int_equal(found.valid, 1);
    int32_t* labels = ball_labels(N);
    double voxels = 0;
    for (int i = 0; i < N * N * N; ++i)
        voxels += labels[i] == 7;
    free(labels);
    assert_true(fabs(found.volume - voxels) < 0.02 * voxels);
    cleft_mesh_destroy(ball);
    cleft_mesh_destroy(some);
    cleft_mesh_destroy(all);
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void the_wanted_number_is_met(void** state)
{
    static const int64_t kWanted[2] = {30000, 90000};
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, N);
    cleft_options* options = coarse();
    (void)state;
    for (int i = 0; i < 2; ++i) {
        cleft_mesh* mesh = NULL;
        assert_ok(context, cleft_options_set_integer(options, CLEFT_OPTION_TETS, kWanted[i]));
        assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
        print_message("%lld of %lld\n", (long long)cleft_mesh_tet_count(mesh), (long long)kWanted[i]);
        assert_true(llabs(cleft_mesh_tet_count(mesh) - kWanted[i]) <= kWanted[i] / 10);
        cleft_mesh_destroy(mesh);
    }
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void a_users_background_is_cleaved(void** state)
{
    /* One coarse mesh of the box by six tetrahedra around its diagonal (Kuhn), made by hand. */
    static const int32_t kKuhn[24] = {0, 1, 3, 7, 0, 3, 2, 7, 0, 2, 6, 7, 0, 6, 4, 7, 0, 4, 5, 7, 0, 5, 1, 7};
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, N);
    double points[24];
    int32_t turned[24];
    cleft_mesh *background = NULL, *mesh = NULL;
    (void)state;
    for (int i = 0; i < 8; ++i)
        for (int axis = 0; axis < 3; ++axis)
            points[3 * i + axis] = (i >> axis & 1) ? N : 0;
    assert_ok(context, cleft_mesh_create(context, 8, points, 6, kKuhn, NULL, 0, &background));
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, background, NULL, &mesh));
    assert_sound(context, mesh, N * N * N);
    cleft_mesh_destroy(mesh);
    cleft_mesh_destroy(background);
    memcpy(turned, kKuhn, sizeof turned);
    turned[2] = 7;
    turned[3] = 3;
    assert_ok(context, cleft_mesh_create(context, 8, points, 6, turned, NULL, 0, &background));
    assert_fails(context, CLEFT_ERROR_INVALID_MESH, cleft_mesh_volume(context, volume, NULL, background, NULL, &mesh));
    assert_null(mesh);
    cleft_mesh_destroy(background);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* What is said again in loops that take long depends on the clock: only news are counted. */
struct watch {
    double last;
    const char* last_stage;
    int news, backwards, outside;
    int cancel_at;
};

static int watching(double fraction, const char* stage, void* user)
{
    struct watch* w = (struct watch*)user;
    w->news += fraction != w->last || stage != w->last_stage;
    w->backwards += fraction < w->last - 1e-12;
    w->outside += !(fraction >= 0 && fraction <= 1) || !stage || !*stage;
    w->last = fraction;
    w->last_stage = stage;
    return w->cancel_at > 0 && w->news >= w->cancel_at;
}

static void progress_moves_forward_and_may_cancel_anywhere(void** state)
{
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, N);
    cleft_options* options = coarse();
    struct watch w = {0};
    cleft_mesh* mesh = NULL;
    (void)state;
    assert_ok(context, cleft_context_set_progress(context, watching, &w));
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    cleft_mesh_destroy(mesh);
    assert_true(w.news > 5);
    assert_int_equal(w.outside, 0);
    assert_int_equal(w.backwards, 0);
    const int news = w.news;
    for (int at = 1; at <= news; at += 1 + news / 25) {
        struct watch cut = {0};
        cut.cancel_at = at;
        assert_ok(context, cleft_context_set_progress(context, watching, &cut));
        assert_fails(context, CLEFT_ERROR_CANCELLED, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
        assert_null(mesh);
    }
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void strict_refuses_a_mesh_without_a_label(void** state)
{
    /* a single voxel of its own in a mesh of one size far above it, cleaved on a user's coarse sizing */
    cleft_context* context = new_context();
    cleft_options* options = NULL;
    const int64_t dims[3] = {24, 24, 24};
    uint8_t* voxels = (uint8_t*)calloc(24 * 24 * 24, 1);
    cleft_volume* volume = NULL;
    cleft_mesh* mesh = NULL;
    (void)state;
    voxels[12 + 24 * (12 + 24 * 12)] = 9;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, voxels, dims, NULL, NULL, &volume));
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SIZE, 11), CLEFT_OK);
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    const int lost = cleft_mesh_label_count(mesh) == 1;
    cleft_mesh_destroy(mesh);
    assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_STRICT, 1), CLEFT_OK);
    const cleft_status status = cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh);
    assert_int_equal(status, lost ? CLEFT_ERROR_LABEL_LOST : CLEFT_OK);
    if (lost)
        assert_non_null(strstr(cleft_context_last_error(context), "label 9"));
    cleft_mesh_destroy(mesh);
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    free(voxels);
    cleft_context_destroy(context);
}

/* What the one call and the five calls are compared for. */
struct request {
    const char *background, *tets, *strict, *improve;
    int strips, has_own_sizes, is_sheared;
};

static cleft_options* options_for(const struct request* r)
{
    static const int32_t stripped = -3;
    cleft_options* options = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "background", r->background), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "tets", r->tets), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "strict", r->strict), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "improve", r->improve), CLEFT_OK);
    assert_int_equal(cleft_options_set_strip(options, &stripped, r->strips), CLEFT_OK);
    return options;
}

static cleft_volume* volume_for(cleft_context* context, const struct request* r)
{
    /* spacings and an origin that no product or sum holds exactly; the last is mirrored */
    static const double affines[2][12] = {{0.7, 0, 0, -3.1, 0, 0.9, 0, 100.3, 0, 0, 1.3, 7.7},
                                          {0.7, 0.1, 0, -3.1, 0.2, -0.9, 0.3, 100.3, 0.1, 0, 1.3, 7.7}};
    const int64_t dims[3] = {N, N, N};
    int32_t* labels = ball_labels(N);
    cleft_volume* volume = NULL;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_INT32, labels, dims, affines[r->is_sheared], NULL,
                                                  &volume));
    free(labels);
    return volume;
}

static void make_sizing(cleft_context* context, const cleft_volume* volume, const struct request* r,
                        const cleft_options* options, cleft_sizing** out)
{
    static float sizes[N * N * N];
    if (!r->has_own_sizes) {
        assert_ok(context, cleft_sizing_create(context, volume, options, out));
        return;
    }
    for (int v = 0; v < N * N * N; ++v)
        sizes[v] = 1.7f + 0.05f * (float)(v % N);
    assert_ok(context, cleft_sizing_create_values(context, volume, CLEFT_TYPE_FLOAT32, sizes, 0, options, out));
}

/* A search for a number makes sizes grow; then they grow from voxel to voxel by no more than was asked for. */
static void own_sizes_are_scaled_by_the_gradation(void** state)
{
    static float sizes[N * N * N];
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, N);
    cleft_options* options = NULL;
    cleft_sizing* sizing = NULL;
    const float* scaled = NULL;
    (void)state;
    for (int v = 0; v < N * N * N; ++v)
        sizes[v] = v % N < N / 2 ? 2 : 3;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_GRADATION, 0.05), CLEFT_OK);
    assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_TETS, 500), CLEFT_OK);
    assert_ok(context, cleft_sizing_create_values(context, volume, CLEFT_TYPE_FLOAT32, sizes, 0, options, &sizing));
    scaled = cleft_sizing_values(sizing);
    assert_true(scaled[0] > 2.1f);
    for (int v = 1; v < N; ++v)
        assert_true(scaled[v] - scaled[v - 1] < 0.051f);
    cleft_sizing_destroy(sizing);
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void assert_same_arrays(const cleft_mesh* a, const cleft_mesh* b)
{
    const size_t points = (size_t)cleft_mesh_point_count(a), tets = (size_t)cleft_mesh_tet_count(a);
    assert_int_equal(cleft_mesh_point_count(b), points);
    assert_int_equal(cleft_mesh_tet_count(b), tets);
    assert_true(tets > 0);
    assert_memory_equal(cleft_mesh_points(a), cleft_mesh_points(b), 3 * points * sizeof(double));
    assert_memory_equal(cleft_mesh_tets(a), cleft_mesh_tets(b), 4 * tets * sizeof(int32_t));
    assert_memory_equal(cleft_mesh_tet_labels(a), cleft_mesh_tet_labels(b), tets * sizeof(int32_t));
}

static void compare(const struct request* r)
{
    cleft_context* context = new_context();
    cleft_volume* volume = volume_for(context, r);
    cleft_options* options = options_for(r);
    cleft_sizing* sizing = NULL;
    cleft_mesh *background = NULL, *cleaved = NULL, *improved = NULL, *stripped = NULL, *whole = NULL, *from = NULL;
    print_message("%s, tets %s, strict %s, improve %s, strips %d, own sizes %d, sheared %d\n", r->background, r->tets,
                  r->strict, r->improve, r->strips, r->has_own_sizes, r->is_sheared);
    make_sizing(context, volume, r, options, &sizing);
    assert_ok(context, cleft_background_create(context, sizing, options, &background));
    assert_ok(context, cleft_mesh_cleave(context, volume, background, options, &cleaved));
    assert_ok(context, cleft_mesh_improve(context, volume, cleaved, options, &improved));
    assert_ok(context, cleft_mesh_strip(context, improved, options, &stripped));
    assert_ok(context, cleft_mesh_volume(context, volume, r->has_own_sizes ? sizing : NULL, NULL, options, &whole));
    assert_same_arrays(stripped, whole);
    assert_int_equal(cleft_options_set_text(options, "tets", "0"), CLEFT_OK);
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, background, options, &from));
    assert_same_arrays(stripped, from);
    cleft_mesh_destroy(from);
    cleft_mesh_destroy(whole);
    cleft_mesh_destroy(stripped);
    cleft_mesh_destroy(improved);
    cleft_mesh_destroy(cleaved);
    cleft_mesh_destroy(background);
    cleft_sizing_destroy(sizing);
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void the_one_call_is_the_five_calls(void** state)
{
    static const char* const backgrounds[3] = {"particles", "lattice", "octree"};
    (void)state;
    for (int b = 0; b < 3; ++b) {
        const struct request requests[] = {
            {backgrounds[b], "0", "false", "fast", 0, 0, 0},    {backgrounds[b], "0", "true", "fast", 1, 0, 1},
            {backgrounds[b], "6000", "false", "fast", 1, 0, 1}, {backgrounds[b], "5000", "false", "off", 0, 1, 0},
            {backgrounds[b], "0", "true", "best", 0, 1, 1},
        };
        for (size_t i = 0; i < sizeof requests / sizeof *requests; ++i)
            compare(requests + i);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sizing_is_computed_constant_or_the_users),
        cmocka_unit_test(stages_one_by_one_give_a_sound_mesh),
        cmocka_unit_test(the_one_call_is_the_five_calls),
        cmocka_unit_test(one_call_gives_the_same_bytes_for_every_thread_count),
        cmocka_unit_test(a_mirrored_world_still_has_positive_tetrahedra),
        cmocka_unit_test(stripped_labels_are_gone_and_the_rest_stays),
        cmocka_unit_test(the_wanted_number_is_met),
        cmocka_unit_test(a_users_background_is_cleaved),
        cmocka_unit_test(progress_moves_forward_and_may_cancel_anywhere),
        cmocka_unit_test(strict_refuses_a_mesh_without_a_label),
        cmocka_unit_test(own_sizes_are_scaled_by_the_gradation),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
