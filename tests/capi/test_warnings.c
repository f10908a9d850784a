/* What is reported in a sentence, and what is not: volumes that differ, masks, ties, options without an effect. */
#include "support/warnings.h"

#include <math.h>

enum { N = 20, VOXELS = N * N * N };

static cleft_options* plain(void)
{
    cleft_options* options = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    return options;
}

static void assert_mesh_reports(cleft_context* context, const cleft_volume* volume, const cleft_options* options,
                                warnings* reported, const char* words)
{
    cleft_mesh* mesh = NULL;
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    assert_reported(reported, words);
    cleft_mesh_destroy(mesh);
}

static void volumes_that_differ_are_told_in_one_sentence(void** state)
{
    const int64_t dims[3] = {24, 24, 24};
    const int32_t sheet = 1;
    warnings reported;
    cleft_context* context = listening_context(&reported);
    uint8_t* voxels = (uint8_t*)calloc(24 * 24 * 24, 1);
    cleft_volume *volume = NULL, *ball = ball_volume(context, N);
    cleft_options *coarse = plain(), *fine = plain();
    (void)state;
    /* sheets of one voxel among tetrahedra six times as large, and a label of fewer than 100 voxels */
    for (int v = 0; v < 24 * 24 * 24; ++v)
        voxels[v] = v / 576 == 7 ? 1 : v / 576 == 16 ? 2 : v == 12 * 577 || v == 12 * 577 + 1 ? 3 : 0;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, voxels, dims, NULL, NULL, &volume));
    assert_int_equal(cleft_options_set_real(coarse, CLEFT_OPTION_SIZE, 6), CLEFT_OK);
    cleft_mesh* mesh = NULL;
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, coarse, &mesh));
    assert_non_null(strstr(reported.all, "differ"));
    assert_non_null(strstr(reported.all, "label 1 ("));
    assert_null(strstr(reported.all, "label 3 ("));
    assert_reported(&reported, "by more than 5 % from that of the voxels: label ");
    cleft_mesh_destroy(mesh);
    mesh = NULL;
    assert_int_equal(cleft_options_set_strip(coarse, &sheet, 1), CLEFT_OK);
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, coarse, &mesh));
    assert_null(strstr(reported.all, "label 1 ("));
    assert_reported(&reported, "label 2 (");
    cleft_mesh_destroy(mesh);
    assert_mesh_reports(context, ball, fine, &reported, NULL);
    free(voxels);
    cleft_options_destroy(fine);
    cleft_options_destroy(coarse);
    cleft_volume_destroy(ball);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* A volume of `count` functions of at most three, whose values are value(function, voxel). */
static cleft_status create_functions(cleft_context* context, int count, float (*value)(int, int), cleft_volume** volume)
{
    const int64_t dims[3] = {N, N, N};
    float* field[3];
    for (int f = 0; f < count; ++f) {
        field[f] = (float*)malloc(sizeof(float) * VOXELS);
        for (int v = 0; v < VOXELS; ++v)
            field[f][v] = value(f, v);
    }
    const cleft_status status = cleft_volume_create_indicators(context, CLEFT_TYPE_FLOAT32, (const void* const*)field,
                                                               count, dims, NULL, NULL, volume);
    for (int f = 0; f < count; ++f)
        free(field[f]);
    return status;
}

static double distance(int voxel, double cx)
{
    const double x = voxel % N + 0.5 - cx, y = voxel / N % N + 0.5 - N / 2.0, z = voxel / N / N + 0.5 - N / 2.0;
    return sqrt(x * x + y * y + z * z);
}

/* Two balls and nothing outside them; function 2 is empty. */
static float masks(int f, int v) { return f < 2 && distance(v, f == 0 ? 6 : 14) < 3.5; }
static float masks_of_255(int f, int v) { return (f == 1 ? 255 : 1) * masks(f, v); }
static float signs(int f, int v) { return 2 * masks(f, v) - 1; }
static float whole_masks(int f, int v) { return f < 2 ? masks(f, v) : masks(0, v) + masks(1, v) == 0; }
static float overlapping(int f, int v) { return f == 2 ? distance(v, 6) >= 3.5F : distance(v, 6) < 3.5F; }
static float shares(int f, int v)
{
    const double outside = distance(v, 10) < 6 ? 0.1 : 0.8;
    return f == 2 ? (float)outside : (float)((1 - outside) * (f == 0 ? 0.7 : 0.3));
}
static float distances(int f, int v)
{
    const double a = 5 - distance(v, 5.5), b = 5 - distance(v, 14.5);
    return (float)(f == 0 ? a : f == 1 ? b : -fmax(a, b));
}
/* The middle plane of the first two lies on voxel centres. */
static float halves(int f, int v) { return f == 2 ? -50.0F : (float)(f == 0 ? v % N - 9 : 9 - v % N); }
static float clipped(int f, int v) { return fmaxf(distances(f, v), f == 2 ? -9.0F : -2.0F); }
static float equal_inside(int f, int v)
{
    return f == 2 ? 0.4F : distance(v, 10) < 5 ? 0.5F : 0.1F * (float)(f + v % 7);
}

static void masks_that_leave_voxels_to_nobody_are_refused_and_ties_told(void** state)
{
    static const struct {
        float (*value)(int, int);
        cleft_status status;
        const char* words; /* of the warning or of the failure */
    } cases[] = {
        {masks, CLEFT_ERROR_ARGUMENT, "of 8000 voxels are in none of the 3 masks"},
        {masks_of_255, CLEFT_ERROR_ARGUMENT, "of 8000 voxels are in none of the 3 masks"},
        {signs, CLEFT_ERROR_ARGUMENT, "of 8000 voxels are in none of the 3 masks"},
        {whole_masks, CLEFT_OK, NULL},
        {overlapping, CLEFT_OK, "voxels are in several of the masks"},
        {shares, CLEFT_OK, NULL},
        {distances, CLEFT_OK, NULL},
        {halves, CLEFT_OK, NULL},
        {equal_inside, CLEFT_OK, "several indicator functions are the greatest at"},
    };
    warnings reported;
    cleft_context* context = listening_context(&reported);
    (void)state;
    for (size_t c = 0; c < sizeof cases / sizeof cases[0]; ++c) {
        cleft_volume* volume = NULL;
        const cleft_status status = create_functions(context, 3, cases[c].value, &volume);
        if (status != cases[c].status)
            fail_msg("case %d: status %d: %s", (int)c, (int)status, cleft_context_last_error(context));
        assert_reported(&reported, status == CLEFT_OK ? cases[c].words : NULL);
        if (status != CLEFT_OK) {
            assert_null(volume);
            assert_non_null(strstr(cleft_context_last_error(context), cases[c].words));
        }
        cleft_volume_destroy(volume);
    }
    cleft_context_destroy(context);
}

static void voxels_of_no_mask_are_counted(void** state)
{
    cleft_context* context = new_context();
    cleft_volume* volume = NULL;
    char sentence[64];
    int unclaimed = 0;
    (void)state;
    for (int v = 0; v < VOXELS; ++v)
        unclaimed += masks(0, v) + masks(1, v) == 0;
    assert_fails(context, CLEFT_ERROR_ARGUMENT, create_functions(context, 3, masks, &volume));
    snprintf(sentence, sizeof sentence, "%d of 8000 voxels", unclaimed);
    assert_non_null(strstr(cleft_context_last_error(context), sentence));
    cleft_context_destroy(context);
}

/* One function alone is signed: inside where it is positive. */
static void one_or_two_functions_are_told_where_they_leave_a_doubt(void** state)
{
    static const struct {
        int count;
        float (*value)(int, int);
        const char* words;
    } cases[] = {
        {1, masks, "the only indicator function is 0 or one other number"},
        {1, signs, NULL},
        {2, clipped, "several indicator functions are the greatest at"},
    };
    warnings reported;
    cleft_context* context = listening_context(&reported);
    (void)state;
    for (size_t c = 0; c < sizeof cases / sizeof cases[0]; ++c) {
        cleft_volume* volume = NULL;
        assert_ok(context, create_functions(context, cases[c].count, cases[c].value, &volume));
        assert_reported(&reported, cases[c].words);
        cleft_volume_destroy(volume);
    }
    cleft_context_destroy(context);
}

/* Every call that takes options and a volume reports that the width of the kernel is another one, or none. */
static void assert_smooth_is_reported(cleft_context* context, const cleft_volume* volume, const cleft_options* options,
                                      warnings* reported, const char* words)
{
    cleft_sizing *sizing = NULL, *own = NULL;
    cleft_mesh *background = NULL, *cleaved = NULL, *improved = NULL;
    float* values = (float*)malloc(sizeof(float) * VOXELS);
    for (int v = 0; v < VOXELS; ++v)
        values[v] = 3;
    assert_ok(context, cleft_sizing_create(context, volume, options, &sizing));
    assert_reported(reported, words);
    assert_ok(context, cleft_sizing_create_values(context, volume, CLEFT_TYPE_FLOAT32, values, 1, options, &own));
    assert_reported(reported, words);
    assert_ok(context, cleft_background_create(context, own, options, &background));
    assert_reported(reported, NULL);
    assert_ok(context, cleft_mesh_cleave(context, volume, background, options, &cleaved));
    assert_reported(reported, words);
    assert_ok(context, cleft_mesh_improve(context, volume, cleaved, options, &improved));
    assert_reported(reported, words);
    assert_mesh_reports(context, volume, options, reported, words);
    free(values);
    cleft_mesh_destroy(improved);
    cleft_mesh_destroy(cleaved);
    cleft_mesh_destroy(background);
    cleft_sizing_destroy(own);
    cleft_sizing_destroy(sizing);
}

static void smooth_that_has_no_effect_is_told(void** state)
{
    const int64_t dims[3] = {N, N, N};
    warnings reported;
    cleft_context* context = listening_context(&reported);
    int32_t* labels = ball_labels(N);
    float* function = (float*)malloc(sizeof(float) * VOXELS);
    cleft_options *three = plain(), *five = plain(), *none = plain();
    cleft_volume *by_three = NULL, *by_default = NULL, *signed_function = NULL;
    (void)state;
    assert_int_equal(cleft_options_set_integer(three, CLEFT_OPTION_SMOOTH, 3), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(five, "smooth", "5"), CLEFT_OK);
    for (int v = 0; v < VOXELS; ++v)
        function[v] = (float)(6 - distance(v, N / 2.0));
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_INT32, labels, dims, NULL, three, &by_three));
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_INT32, labels, dims, NULL, NULL, &by_default));
    assert_ok(context, cleft_volume_create_indicators(context, CLEFT_TYPE_FLOAT32, (const void* const*)&function, 1,
                                                      dims, NULL, NULL, &signed_function));
    assert_reported(&reported, NULL);
    assert_smooth_is_reported(context, by_three, three, &reported, NULL);
    assert_smooth_is_reported(context, by_three, none, &reported, NULL);
    assert_mesh_reports(context, by_three, NULL, &reported, NULL);
    assert_smooth_is_reported(context, by_three, five, &reported,
                              "smooth is 5 and has no effect: the volume was made with 3");
    assert_mesh_reports(context, by_default, five, &reported, NULL);
    assert_mesh_reports(context, by_default, three, &reported,
                        "smooth is 3 and has no effect: the volume was made with 5");
    assert_mesh_reports(context, signed_function, none, &reported, NULL);
    assert_smooth_is_reported(context, signed_function, five, &reported,
                              "smooth has no effect on a volume of indicator");
    free(labels);
    free(function);
    cleft_volume_destroy(signed_function);
    cleft_volume_destroy(by_default);
    cleft_volume_destroy(by_three);
    cleft_options_destroy(none);
    cleft_options_destroy(five);
    cleft_options_destroy(three);
    cleft_context_destroy(context);
}

static void a_number_for_a_background_that_is_given_is_told(void** state)
{
    warnings reported;
    cleft_context* context = listening_context(&reported);
    cleft_volume* volume = ball_volume(context, N);
    cleft_options* options = plain();
    cleft_sizing* sizing = NULL;
    cleft_mesh *background = NULL, *mesh = NULL;
    (void)state;
    assert_ok(context, cleft_sizing_create_constant(context, volume, 3, &sizing));
    assert_ok(context, cleft_background_create(context, sizing, NULL, &background));
    assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_TETS, 500000), CLEFT_OK);
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, background, options, &mesh));
    assert_reported(&reported, "tets has no effect on a background that is given");
    cleft_mesh_destroy(mesh);
    cleft_mesh_destroy(background);
    cleft_sizing_destroy(sizing);
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void assert_background_reports(cleft_context* context, const cleft_sizing* sizing, const cleft_options* options,
                                      warnings* reported, const char* words)
{
    cleft_mesh* background = NULL;
    assert_ok(context, cleft_background_create(context, sizing, options, &background));
    assert_reported(reported, words);
    cleft_mesh_destroy(background);
}

/* The stage of sizing searches for the number, and the one call does on a field that no search has scaled. */
static void a_number_that_the_sizes_were_not_made_for_is_told(void** state)
{
    enum { WANTED = 20000 };
    warnings reported;
    cleft_context* context = listening_context(&reported);
    cleft_volume* volume = ball_volume(context, N);
    cleft_options* options = plain();
    cleft_sizing *constant = NULL, *scaled = NULL;
    cleft_mesh* mesh = NULL;
    float* values = (float*)malloc(sizeof(float) * VOXELS);
    (void)state;
    for (int v = 0; v < VOXELS; ++v)
        values[v] = 3;
    assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_TETS, WANTED), CLEFT_OK);
    assert_ok(context, cleft_sizing_create_constant(context, volume, 3, &constant));
    assert_background_reports(context, constant, options, &reported,
                              "tets is 20000 and has no effect: the sizing field was made without it");
    assert_ok(context, cleft_mesh_volume(context, volume, constant, NULL, options, &mesh));
    assert_reported(&reported, NULL);
    assert_in_range(cleft_mesh_tet_count(mesh), WANTED * 9 / 10, WANTED * 11 / 10);
    assert_ok(context, cleft_sizing_create_values(context, volume, CLEFT_TYPE_FLOAT32, values, 0, options, &scaled));
    assert_background_reports(context, scaled, options, &reported, NULL);
    assert_background_reports(context, scaled, NULL, &reported, NULL);
    assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_TETS, 2 * WANTED), CLEFT_OK);
    assert_background_reports(context, scaled, options, &reported,
                              "tets is 40000 and has no effect: the sizing field was made with 20000");
    free(values);
    cleft_mesh_destroy(mesh);
    cleft_sizing_destroy(scaled);
    cleft_sizing_destroy(constant);
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* Once, by the calls that compute sizes, also where these are computed several times to keep to a number. */
static void a_size_of_a_label_that_is_not_there_is_told(void** state)
{
    static const char* const words = "a size is given for label 9, which the volume does not have";
    warnings reported;
    cleft_context* context = listening_context(&reported);
    cleft_volume* volume = ball_volume(context, N);
    cleft_options *known = plain(), *unknown = plain(), *wrong = plain();
    cleft_sizing *sizing = NULL, *same = NULL;
    cleft_mesh* mesh = NULL;
    (void)state;
    assert_int_equal(cleft_options_set_label_size(known, 7, 2), CLEFT_OK);
    assert_int_equal(cleft_options_set_label_size(unknown, 7, 2), CLEFT_OK);
    assert_int_equal(cleft_options_set_label_size(unknown, 9, 1), CLEFT_OK);
    assert_ok(context, cleft_sizing_create(context, volume, known, &sizing));
    assert_reported(&reported, NULL);
    assert_ok(context, cleft_sizing_create(context, volume, unknown, &same));
    assert_reported(&reported, words);
    assert_memory_equal(cleft_sizing_values(sizing), cleft_sizing_values(same), sizeof(float) * VOXELS);
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, unknown, &mesh));
    assert_reported(&reported, words);
    cleft_mesh_destroy(mesh);
    assert_ok(context, cleft_mesh_volume(context, volume, sizing, NULL, unknown, &mesh));
    assert_reported(&reported, NULL);
    assert_int_equal(cleft_options_set_label_size(wrong, 7, 1e40), CLEFT_OK);
    cleft_sizing_destroy(same);
    assert_fails(context, CLEFT_ERROR_OPTION, cleft_sizing_create(context, volume, wrong, &same));
    assert_non_null(strstr(cleft_context_last_error(context), "the size of label 7 is 1e+40; it must be 0, or within"));
    cleft_mesh_destroy(mesh);
    cleft_sizing_destroy(sizing);
    cleft_options_destroy(wrong);
    cleft_options_destroy(unknown);
    cleft_options_destroy(known);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* A size that is given for interfaces holds, so that a raised least size of features cannot keep to max_tets. */
static void a_number_that_sizes_of_the_user_exceed_is_told(void** state)
{
    warnings reported;
    cleft_context* context = listening_context(&reported);
    cleft_volume* volume = ball_volume(context, N);
    cleft_options *features = plain(), *given = plain();
    cleft_sizing* sizing = NULL;
    (void)state;
    assert_int_equal(cleft_options_set_integer(features, CLEFT_OPTION_MAX_TETS, 2000), CLEFT_OK);
    assert_int_equal(cleft_options_set_real(features, CLEFT_OPTION_FEATURE_SCALE, 0.1), CLEFT_OK);
    assert_ok(context, cleft_sizing_create(context, volume, features, &sizing));
    assert_reported(&reported, " to keep to max_tets, 2000");
    cleft_sizing_destroy(sizing);
    sizing = NULL;
    assert_int_equal(cleft_options_set_integer(given, CLEFT_OPTION_MAX_TETS, 2000), CLEFT_OK);
    assert_int_equal(cleft_options_set_real(given, CLEFT_OPTION_INTERFACE_SIZE, 1), CLEFT_OK);
    assert_ok(context, cleft_sizing_create(context, volume, given, &sizing));
    assert_reported(&reported, "more than max_tets, 2000");
    cleft_sizing_destroy(sizing);
    cleft_options_destroy(given);
    cleft_options_destroy(features);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* Features ask for many more. What is counted is the background that is made: an octree has more than particles. */
static void max_tets_limits_each_background(void** state)
{
    static const char* const kinds[3] = {"particles", "lattice", "octree"};
    warnings reported;
    cleft_context* context = listening_context(&reported);
    cleft_volume* volume = ball_volume(context, 32);
    (void)state;
    for (int kind = 0; kind < 3; ++kind) {
        cleft_options* options = plain();
        cleft_sizing* sizing = NULL;
        cleft_mesh* background = NULL;
        assert_int_equal(cleft_options_set_text(options, "background", kinds[kind]), CLEFT_OK);
        assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_MAX_TETS, 5000), CLEFT_OK);
        assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_FEATURE_SCALE, 0.1), CLEFT_OK);
        assert_ok(context, cleft_sizing_create(context, volume, options, &sizing));
        assert_ok(context, cleft_background_create(context, sizing, options, &background));
        print_message("%s: %d\n", kinds[kind], (int)cleft_mesh_tet_count(background));
        assert_in_range(cleft_mesh_tet_count(background), 2500, 6000);
        assert_reported(&reported, " to keep to max_tets, 5000"); /* by the one call or by the other */
        cleft_mesh_destroy(background);
        cleft_sizing_destroy(sizing);
        cleft_options_destroy(options);
    }
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* Whether the stages are called one by one, where the first of them searches for the number, or by the one call. */
static void a_coarse_lattice_is_told_once(void** state)
{
    warnings reported;
    cleft_context* context = listening_context(&reported);
    cleft_volume* volume = ball_volume(context, N);
    cleft_options* options = plain();
    cleft_sizing* sizing = NULL;
    cleft_mesh *background = NULL, *mesh = NULL;
    (void)state;
    assert_int_equal(cleft_options_set_text(options, "background", "lattice"), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "tets", "4000"), CLEFT_OK);
    assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_FEATURE_SCALE, 0.1), CLEFT_OK);
    assert_ok(context, cleft_sizing_create(context, volume, options, &sizing));
    assert_reported(&reported, NULL);
    assert_ok(context, cleft_background_create(context, sizing, options, &background));
    assert_reported(&reported, "the lattice has one size");
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    assert_reported(&reported, "the lattice has one size");
    cleft_mesh_destroy(mesh);
    cleft_mesh_destroy(background);
    cleft_sizing_destroy(sizing);
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(volumes_that_differ_are_told_in_one_sentence),
        cmocka_unit_test(masks_that_leave_voxels_to_nobody_are_refused_and_ties_told),
        cmocka_unit_test(voxels_of_no_mask_are_counted),
        cmocka_unit_test(one_or_two_functions_are_told_where_they_leave_a_doubt),
        cmocka_unit_test(smooth_that_has_no_effect_is_told),
        cmocka_unit_test(a_number_for_a_background_that_is_given_is_told),
        cmocka_unit_test(a_number_that_the_sizes_were_not_made_for_is_told),
        cmocka_unit_test(a_size_of_a_label_that_is_not_there_is_told),
        cmocka_unit_test(a_number_that_sizes_of_the_user_exceed_is_told),
        cmocka_unit_test(max_tets_limits_each_background),
        cmocka_unit_test(a_coarse_lattice_is_told_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
