/* What is beyond the limits that the header states: reported in a sentence where it comes in, never meshed badly. */
#include "support/warnings.h"

#include <float.h>
#include <math.h>

enum { N = 10, VOXELS = N * N * N };

static const double kPi = 3.14159265358979323846;
/* One coarse mesh of a box by six tetrahedra around its diagonal (Kuhn). */
static const int32_t kKuhn[24] = {0, 1, 3, 7, 0, 3, 2, 7, 0, 2, 6, 7, 0, 6, 4, 7, 0, 4, 5, 7, 0, 5, 1, 7};

static void assert_sound(cleft_context* context, const cleft_mesh* mesh)
{
    cleft_validation found = {.struct_size = sizeof found};
    assert_ok(context, cleft_mesh_validate(context, mesh, 1, &found));
    if (!found.valid)
        fail_msg("%s", cleft_context_last_error(context));
}

static cleft_options* options_of(const char* background)
{
    cleft_options* options = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "background", background), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "max_tets", "50000"), CLEFT_OK);
    return options;
}

static const char* const kBackgrounds[] = {"particles", "lattice", "octree"};

/* `sizing` may be NULL. */
static void assert_sound_on_all_backgrounds(cleft_context* context, const cleft_volume* volume,
                                            const cleft_sizing* sizing)
{
    for (int b = 0; b < 3; ++b) {
        cleft_options* options = options_of(kBackgrounds[b]);
        cleft_mesh* mesh = NULL;
        assert_ok(context, cleft_mesh_volume(context, volume, sizing, NULL, options, &mesh));
        assert_sound(context, mesh);
        cleft_mesh_destroy(mesh);
        cleft_options_destroy(options);
    }
}

struct world {
    double spacing[3], origin;
};

static cleft_status make_volume(cleft_context* context, struct world w, cleft_volume** out)
{
    const int64_t dims[3] = {N, N, N};
    const double affine[12] = {w.spacing[0], 0, 0, w.origin, 0, w.spacing[1], 0, 0, 0, 0, w.spacing[2], 0};
    int32_t* labels = ball_labels(N);
    const cleft_status status = cleft_volume_create_labels(context, CLEFT_TYPE_INT32, labels, dims, affine, NULL, out);
    free(labels);
    return status;
}

static void worlds_within_the_limits_give_sound_meshes(void** state)
{
    static const struct world kWithin[] = {{{1e-15, 1e-15, 1e-15}, 0},
                                           {{1e15, 1e15, 1e15}, 0},
                                           {{1, 100, 1}, 0},
                                           {{12, 1, 12}, 0},
                                           {{1, 1, 1}, 9.9e13},
                                           {{1e-9, 1e-9, 1e-9}, 9.9e4},
                                           {{1e-15, 1e-14, 1e-15}, 0.005},
                                           {{1e14, 1e15, 3e14}, 1e25}};
    cleft_context* context = new_context();
    (void)state;
    for (size_t i = 0; i < sizeof kWithin / sizeof *kWithin; ++i) {
        cleft_volume* volume = NULL;
        assert_ok(context, make_volume(context, kWithin[i], &volume));
        assert_sound_on_all_backgrounds(context, volume, NULL);
        cleft_volume_destroy(volume);
    }
    cleft_context_destroy(context);
}

static void worlds_beyond_the_limits_are_refused(void** state)
{
    static const struct {
        struct world world;
        const char* words;
    } kBeyond[] = {
        {{{0.9e-15, 1, 1}, 0}, "spacing along the 1st axis is 9e-16"},
        {{{1, 1e20, 1}, 0}, "spacing along the 2nd axis is 1e+20"},
        {{{1, 1, 1e60}, 0}, "spacing along the 3rd axis is 1e+60"},
        {{{1, 1, 3e4}, 0}, "30000 times the least"},
        {{{1e8, 1, 1}, 0}, "1e+08 times the least"},
        {{{1, 1, 1}, 1e16}, "1e+16 spacings away"},
        {{{1e-9, 1e-9, 1e-9}, 1e7}, "1e+16 spacings away"},
    };
    cleft_context* context = new_context();
    (void)state;
    for (size_t i = 0; i < sizeof kBeyond / sizeof *kBeyond; ++i) {
        cleft_volume* volume = NULL;
        assert_fails(context, CLEFT_ERROR_ARGUMENT, make_volume(context, kBeyond[i].world, &volume));
        if (!strstr(cleft_context_last_error(context), kBeyond[i].words))
            fail_msg("%s", cleft_context_last_error(context));
        assert_null(volume);
    }
    cleft_context_destroy(context);
}

/* Doubles near 9.9e13 are 1/64 apart, and the lattice asks for points at an eightieth of a voxel. */
static void what_a_far_world_cannot_hold_is_refused(void** state)
{
    const int64_t dims[3] = {1, 1, 1};
    const double affine[12] = {1, 0, 0, 9.9e13, 0, 1, 0, 0, 0, 0, 1, 0};
    const int32_t label = 1;
    cleft_context* context = new_context();
    cleft_options* options = options_of("lattice");
    cleft_volume* volume = NULL;
    cleft_sizing* sizing = NULL;
    cleft_mesh* mesh = NULL;
    (void)state;
    assert_int_equal(cleft_options_set_text(options, "max_tets", "20000000"), CLEFT_OK);
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_INT32, &label, dims, affine, options, &volume));
    assert_ok(context, cleft_sizing_create_constant(context, volume, 1.0 / 80, &sizing));
    assert_fails(context, CLEFT_ERROR_ARGUMENT, cleft_mesh_volume(context, volume, sizing, NULL, options, &mesh));
    if (!strstr(cleft_context_last_error(context), "origin"))
        fail_msg("%s", cleft_context_last_error(context));
    assert_null(mesh);
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
    cleft_options_destroy(options);
    cleft_context_destroy(context);
}

/* A size that is a sentinel for "any" in one voxel of many: single precision holds seven digits of sixteen. */
static void a_size_far_above_its_neighbours_is_meshed(void** state)
{
    static double sizes[VOXELS];
    cleft_context* context = new_context();
    cleft_volume* volume = NULL;
    cleft_sizing* sizing = NULL;
    const struct world plain = {{1, 1, 1}, 0};
    (void)state;
    assert_ok(context, make_volume(context, plain, &volume));
    for (int v = 0; v < VOXELS; ++v)
        sizes[v] = v == VOXELS / 3 ? 1e16 : 1.5 + 0.01 * (v % 7);
    assert_ok(context, cleft_sizing_create_values(context, volume, CLEFT_TYPE_FLOAT64, sizes, 0, NULL, &sizing));
    assert_sound_on_all_backgrounds(context, volume, sizing);
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* Two labels side by side in `side` x `side` x 1 voxels of 10 x 10 x 1. */
static cleft_volume* plate_volume(cleft_context* context, int side)
{
    const int64_t dims[3] = {side, side, 1};
    const double affine[12] = {10, 0, 0, 0, 0, 10, 0, 0, 0, 0, 1, 0};
    int32_t labels[1600];
    cleft_volume* volume = NULL;
    assert_true(side <= 40);
    for (int v = 0; v < side * side; ++v)
        labels[v] = v % side < side / 2;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_INT32, labels, dims, affine, NULL, &volume));
    return volume;
}

/* Cells are no longer than the box is thin, so that a plate of them cannot keep to any number. */
static void assert_plate_is_refused(const char* background, const char* tets, const char* words)
{
    cleft_context* context = new_context();
    cleft_volume* volume = plate_volume(context, 40); /* 400 x 400 x 1 cells of 12 tetrahedra */
    cleft_mesh* mesh = NULL;
    cleft_options* options = options_of(background);
    assert_int_equal(cleft_options_set_text(options, "tets", tets), CLEFT_OK);
    assert_fails(context, CLEFT_ERROR_TOO_LARGE, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    if (!strstr(cleft_context_last_error(context), words))
        fail_msg("%s", cleft_context_last_error(context));
    assert_null(mesh);
    cleft_volume_destroy(volume);
    cleft_options_destroy(options);
    cleft_context_destroy(context);
}

static void cells_of_a_plate_keep_to_max_tets_or_are_refused(void** state)
{
    (void)state;
    assert_plate_is_refused("lattice", "0", "about 1920000 tetrahedra, more than max_tets, 50000");
    assert_plate_is_refused("octree", "0", "about 1920000 tetrahedra, whatever their size, more than max_tets, 50000");
}

static void a_number_that_is_far_below_that_of_a_plate_is_refused(void** state)
{
    static const char kWords[] = "about 1920000 tetrahedra, whatever their size, far more than the wanted number, 5000";
    (void)state;
    assert_plate_is_refused("lattice", "5000", kWords);
    assert_plate_is_refused("octree", "5000", kWords);
}

/* A plate that is made fast has its least number, after one mesh, and the warning tells it. */
static void a_search_ends_where_the_number_falls_no_more(void** state)
{
    warnings reported;
    cleft_context* context = listening_context(&reported);
    cleft_volume* volume = plate_volume(context, 8);
    (void)state;
    for (int b = 0; b < 2; ++b) {
        cleft_options* options = options_of(b ? "octree" : "lattice");
        cleft_mesh* mesh = NULL;
        double rounds = 0;
        assert_int_equal(cleft_options_set_text(options, "tets", "500"), CLEFT_OK);
        assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
        assert_sound(context, mesh);
        for (int64_t i = 0; i < cleft_context_metric_count(context); ++i) {
            const char* name = NULL;
            double value = 0;
            assert_int_equal(cleft_context_metric(context, i, &name, &value), CLEFT_OK);
            if (!strcmp(name, "pipeline.rounds.count"))
                rounds = value;
        }
        assert_true(rounds >= 1 && rounds <= 2);
        assert_reported(&reported, "was not met");
        memset(&reported, 0, sizeof reported);
        cleft_mesh_destroy(mesh);
        cleft_options_destroy(options);
    }
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* Distances from a ball of radius 3 within a band, and a sentinel beyond it. */
static double volume_of_ball(cleft_context* context, double band, double sentinel, const char* background)
{
    const int64_t dims[3] = {N, N, N};
    static double f[VOXELS];
    const void* fields[1] = {f};
    cleft_options* options = options_of(background);
    cleft_volume* volume = NULL;
    cleft_mesh* mesh = NULL;
    cleft_report* report = NULL;
    cleft_label_report row = {.struct_size = sizeof row};
    for (int v = 0; v < VOXELS; ++v) {
        const double d = 3 - sqrt(pow(v % N - 4.5, 2) + pow(v / N % N - 4.5, 2) + pow(v / N / N - 4.5, 2));
        f[v] = fabs(d) <= band ? d : d < 0 ? -sentinel : sentinel;
    }
    assert_ok(context,
              cleft_volume_create_indicators(context, CLEFT_TYPE_FLOAT64, fields, 1, dims, NULL, NULL, &volume));
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    assert_sound(context, mesh);
    assert_ok(context, cleft_report_create(context, volume, mesh, &report));
    assert_ok(context, cleft_report_label(report, 1, &row));
    cleft_report_destroy(report);
    cleft_mesh_destroy(mesh);
    cleft_volume_destroy(volume);
    cleft_options_destroy(options);
    return row.mesh_volume;
}

static void sentinels_lie_a_little_beyond_their_band(void** state)
{
    static const double kSentinels[] = {FLT_MAX, DBL_MAX, 2e30};
    const double ball = 4 * kPi / 3 * 27;
    warnings reported;
    cleft_context* context = listening_context(&reported);
    (void)state;
    for (size_t s = 0; s < sizeof kSentinels / sizeof *kSentinels; ++s)
        for (int b = 0; b < 3; ++b) {
            memset(&reported, 0, sizeof reported);
            const double found = volume_of_ball(context, 1.5, kSentinels[s], kBackgrounds[b]);
            if (fabs(found - ball) > 0.05 * ball)
                fail_msg("%s, sentinel %g: %g of %g", kBackgrounds[b], kSentinels[s], found, ball);
            assert_non_null(strstr(reported.all, "beyond 1e+30 and taken as far away"));
        }
    cleft_context_destroy(context);
}

static void noise_of_sentinels_alone_is_meshed_by_its_signs(void** state)
{
    const int64_t dims[3] = {4, 4, 4};
    float f[64];
    const void* fields[1] = {f};
    cleft_context* context = new_context();
    cleft_volume* volume = NULL;
    (void)state;
    for (int v = 0; v < 64; ++v)
        f[v] = v * 7919 % 13 < 6 ? 1e38f : -1e38f;
    assert_ok(context,
              cleft_volume_create_indicators(context, CLEFT_TYPE_FLOAT32, fields, 1, dims, NULL, NULL, &volume));
    assert_sound_on_all_backgrounds(context, volume, NULL);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void box_points(double lo, double hi, double points[24])
{
    for (int i = 0; i < 8; ++i)
        for (int axis = 0; axis < 3; ++axis)
            points[3 * i + axis] = (i >> axis & 1) ? hi : lo;
}

/* Cleaving and meshing with a background of `count` tetrahedra; the status of both, which must be the same. */
static cleft_status worked_on(cleft_context* context, int64_t points, const double* x, int64_t count,
                              const int32_t* tets)
{
    cleft_volume* volume = ball_volume(context, N);
    cleft_mesh *background = NULL, *cleaved = NULL, *meshed = NULL;
    assert_ok(context, cleft_mesh_create(context, points, x, count, tets, NULL, 0, &background));
    const cleft_status status = cleft_mesh_cleave(context, volume, background, NULL, &cleaved);
    assert_int_equal(cleft_mesh_volume(context, volume, NULL, background, NULL, &meshed), status);
    if (status != CLEFT_OK) {
        assert_null(cleaved);
        assert_null(meshed);
        assert_true(cleft_context_last_error(context)[0] != '\0');
    }
    cleft_mesh_destroy(meshed);
    cleft_mesh_destroy(cleaved);
    cleft_mesh_destroy(background);
    cleft_volume_destroy(volume);
    return status;
}

static void backgrounds_are_checked_whole(void** state)
{
    static const int32_t kTwice[8] = {0, 1, 2, 3, 0, 1, 2, 3}, kSameSide[8] = {0, 1, 2, 3, 0, 1, 2, 4};
    static const int32_t kThree[12] = {0, 1, 2, 3, 0, 2, 1, 4, 0, 1, 2, 5};
    static const int32_t kPointTwice[4] = {0, 0, 0, 0}, kTurned[4] = {1, 0, 2, 3}, kFlat[4] = {0, 1, 2, 6};
    static const double kPoints[21] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4, 1, 1, -4, 1, 1, 3, 4, 4, 0};
    cleft_context* context = new_context();
    (void)state;
    assert_int_equal(worked_on(context, 7, kPoints, 2, kTwice), CLEFT_ERROR_INVALID_MESH);
    assert_int_equal(worked_on(context, 7, kPoints, 2, kSameSide), CLEFT_ERROR_INVALID_MESH);
    assert_int_equal(worked_on(context, 7, kPoints, 3, kThree), CLEFT_ERROR_INVALID_MESH);
    assert_int_equal(worked_on(context, 7, kPoints, 1, kPointTwice), CLEFT_ERROR_INVALID_MESH);
    assert_int_equal(worked_on(context, 7, kPoints, 1, kTurned), CLEFT_ERROR_INVALID_MESH);
    assert_int_equal(worked_on(context, 7, kPoints, 1, kFlat), CLEFT_ERROR_INVALID_MESH);
    assert_int_equal(worked_on(context, 0, NULL, 0, NULL), CLEFT_ERROR_ARGUMENT);
    cleft_context_destroy(context);
}

static void overlapping_and_distant_backgrounds_are_refused(void** state)
{
    double two[48], away[24];
    int32_t tets[48];
    cleft_context* context = new_context();
    (void)state;
    box_points(0, N, two);
    box_points(0.1, N - 0.1, two + 24);
    for (int i = 0; i < 48; ++i)
        tets[i] = kKuhn[i % 24] + (i < 24 ? 0 : 8);
    assert_int_equal(worked_on(context, 16, two, 12, tets), CLEFT_ERROR_INVALID_MESH);
    box_points(1e9, 1e9 + 1, away);
    assert_int_equal(worked_on(context, 8, away, 6, kKuhn), CLEFT_ERROR_ARGUMENT);
    cleft_context_destroy(context);
}

static void backgrounds_that_do_not_fit_the_box_are_told(void** state)
{
    static const struct {
        double lo, hi;
        const char* words;
    } kBoxes[] = {{0, N, NULL}, {0, N / 2, "fills 12.5 % of the volume's box"}, {-1, N, "reaches out"}};
    warnings reported;
    cleft_context* context = listening_context(&reported);
    cleft_volume* volume = ball_volume(context, N);
    (void)state;
    for (int i = 0; i < 3; ++i) {
        double points[27];
        cleft_mesh *background = NULL, *cleaved = NULL;
        box_points(kBoxes[i].lo, kBoxes[i].hi, points);
        points[24] = points[25] = points[26] = 77; /* a point that is not used is no fault */
        assert_ok(context, cleft_mesh_create(context, 9, points, 6, kKuhn, NULL, 0, &background));
        assert_ok(context, cleft_mesh_cleave(context, volume, background, NULL, &cleaved));
        assert_reported(&reported, kBoxes[i].words);
        cleft_validation found = {.struct_size = sizeof found};
        assert_ok(context, cleft_mesh_validate(context, cleaved, 0, &found));
        assert_true(found.valid);
        cleft_mesh_destroy(cleaved);
        cleft_mesh_destroy(background);
    }
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void meshes_to_improve_and_strip_are_checked(void** state)
{
    static const double kPoints[12] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4};
    static const int32_t kTurned[8] = {1, 0, 2, 3, 1, 0, 2, 3}, kLabels[2] = {7, 1000}, kStrip = 1000;
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, N);
    cleft_options* options = options_of("lattice");
    cleft_mesh *given = NULL, *made = NULL;
    (void)state;
    assert_int_equal(cleft_options_set_strip(options, &kStrip, 1), CLEFT_OK);
    assert_ok(context, cleft_mesh_create(context, 4, kPoints, 2, kTurned, kLabels, 0, &given));
    assert_fails(context, CLEFT_ERROR_INVALID_MESH, cleft_mesh_improve(context, volume, given, NULL, &made));
    assert_null(made);
    assert_fails(context, CLEFT_ERROR_INVALID_MESH, cleft_mesh_strip(context, given, options, &made));
    assert_null(made);
    cleft_mesh_destroy(given);
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void sizes_beyond_the_limits_are_refused(void** state)
{
    static const double kBad[] = {0, -1, 1e-31, 1e31, 1e300, NAN, INFINITY};
    static const double kExtreme[] = {1e-30, 1e-20, 1e-9, 1e9, 1e20, 1e30};
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, N);
    cleft_sizing* sizing = NULL;
    (void)state;
    for (size_t i = 0; i < sizeof kBad / sizeof *kBad; ++i)
        assert_fails(context, isfinite(kBad[i]) ? CLEFT_ERROR_ARGUMENT : CLEFT_ERROR_NOT_FINITE,
                     cleft_sizing_create_constant(context, volume, kBad[i], &sizing));
    for (size_t i = 0; i < sizeof kExtreme / sizeof *kExtreme; ++i) {
        assert_ok(context, cleft_sizing_create_constant(context, volume, kExtreme[i], &sizing));
        for (int b = 0; b < 3; ++b) {
            cleft_options* options = options_of(kBackgrounds[b]);
            cleft_mesh* mesh = NULL;
            const cleft_status status = cleft_mesh_volume(context, volume, sizing, NULL, options, &mesh);
            if (status != (kExtreme[i] < 1 ? CLEFT_ERROR_TOO_LARGE : CLEFT_OK))
                fail_msg("%g, %s: %d %s", kExtreme[i], kBackgrounds[b], (int)status, cleft_context_last_error(context));
            assert_null(strstr(cleft_context_last_error(context), "-92233"));
            if (mesh)
                assert_sound(context, mesh);
            cleft_mesh_destroy(mesh);
            cleft_options_destroy(options);
        }
        cleft_sizing_destroy(sizing);
    }
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(worlds_within_the_limits_give_sound_meshes),
        cmocka_unit_test(worlds_beyond_the_limits_are_refused),
        cmocka_unit_test(what_a_far_world_cannot_hold_is_refused),
        cmocka_unit_test(a_size_far_above_its_neighbours_is_meshed),
        cmocka_unit_test(cells_of_a_plate_keep_to_max_tets_or_are_refused),
        cmocka_unit_test(a_number_that_is_far_below_that_of_a_plate_is_refused),
        cmocka_unit_test(a_search_ends_where_the_number_falls_no_more),
        cmocka_unit_test(sentinels_lie_a_little_beyond_their_band),
        cmocka_unit_test(noise_of_sentinels_alone_is_meshed_by_its_signs),
        cmocka_unit_test(backgrounds_are_checked_whole),
        cmocka_unit_test(overlapping_and_distant_backgrounds_are_refused),
        cmocka_unit_test(backgrounds_that_do_not_fit_the_box_are_told),
        cmocka_unit_test(meshes_to_improve_and_strip_are_checked),
        cmocka_unit_test(sizes_beyond_the_limits_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
