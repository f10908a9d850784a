/* Labels that are left out: what is kept is counted, lists are checked against the volume, and nothing empty comes out.
 */
#include "support/warnings.h"

#include <math.h>

enum { N = 20 };

static const int32_t kBackgrounds[3] = {CLEFT_BACKGROUND_PARTICLES, CLEFT_BACKGROUND_LATTICE, CLEFT_BACKGROUND_OCTREE};

static cleft_options* plain(void)
{
    cleft_options* options = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    return options;
}

static void set(cleft_options* options, cleft_option key, int64_t value)
{
    assert_int_equal(cleft_options_set_integer(options, key, value), CLEFT_OK);
}

static void the_wanted_number_is_that_of_what_is_kept(void** state)
{
    static const int32_t lists[3][2] = {{-3, 1000}, {1000, 1000}, {7, 7}};
    (void)state;
    warnings reported;
    cleft_context* context = listening_context(&reported);
    cleft_volume* volume = ball_volume(context, N);
    for (int b = 0; b < 3; ++b)
        for (int l = 0; l < 3; ++l) {
            cleft_options* options = plain();
            cleft_mesh* mesh = NULL;
            set(options, CLEFT_OPTION_BACKGROUND, kBackgrounds[b]);
            set(options, CLEFT_OPTION_TETS, 20000);
            assert_int_equal(cleft_options_set_strip(options, lists[l], 2), CLEFT_OK);
            assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
            const int is_met = fabs((double)cleft_mesh_tet_count(mesh) / 20000 - 1) <= 0.1;
            /* cells fit the box in whole numbers: a lattice may jump over the wanted one, and says so */
            if (!is_met && kBackgrounds[b] == CLEFT_BACKGROUND_PARTICLES)
                fail_msg("background %d, list %d: %d", b, l, (int)cleft_mesh_tet_count(mesh));
            assert_int_equal(is_met, strstr(reported.all, "was not met") == NULL);
            memset(&reported, 0, sizeof reported);
            cleft_mesh_destroy(mesh);
            cleft_options_destroy(options);
        }
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* One label of a few voxels alone: as many tetrahedra as were wanted in it would take millions around it. */
static void a_number_that_would_fill_the_memory_is_not_met_and_told(void** state)
{
    const int64_t dims[3] = {N, N, N};
    const int32_t speck = 9;
    warnings reported;
    cleft_context* context = listening_context(&reported);
    uint8_t* voxels = (uint8_t*)calloc(N * N * N, 1);
    cleft_volume* volume = NULL;
    (void)state;
    for (int i = 9; i < 12; ++i)
        voxels[i + N * (10 + N * 10)] = 9;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, voxels, dims, NULL, NULL, &volume));
    for (int b = 0; b < 3; ++b) {
        cleft_options* options = plain();
        cleft_mesh* mesh = NULL;
        set(options, CLEFT_OPTION_BACKGROUND, kBackgrounds[b]);
        set(options, CLEFT_OPTION_TETS, 20000);
        set(options, CLEFT_OPTION_MAX_TETS, 100000);
        assert_int_equal(cleft_options_set_only(options, &speck, 1), CLEFT_OK);
        assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
        assert_true(cleft_mesh_tet_count(mesh) > 0 && cleft_mesh_tet_count(mesh) < 18000);
        assert_non_null(strstr(reported.all, "keeps to max_tets, 100000"));
        memset(&reported, 0, sizeof reported);
        for (int64_t i = 0; i < cleft_context_metric_count(context); ++i) {
            const char* name = NULL;
            double value = 0;
            assert_ok(context, cleft_context_metric(context, i, &name, &value));
            if (!strcmp(name, "background.tets"))
                assert_true(value < 110000);
            if (!strcmp(name, "pipeline.rounds.count"))
                assert_true(value <= 8);
        }
        cleft_mesh_destroy(mesh);
        cleft_options_destroy(options);
    }
    free(voxels);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void a_sizing_field_expects_what_is_kept(void** state)
{
    const int32_t ball = 7;
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, N);
    cleft_options *all = plain(), *kept = plain(), *left_out = plain();
    cleft_sizing* sizing[3] = {NULL, NULL, NULL};
    (void)state;
    assert_int_equal(cleft_options_set_only(kept, &ball, 1), CLEFT_OK);
    assert_int_equal(cleft_options_set_strip(left_out, &ball, 1), CLEFT_OK);
    assert_ok(context, cleft_sizing_create(context, volume, all, &sizing[0]));
    assert_ok(context, cleft_sizing_create(context, volume, kept, &sizing[1]));
    assert_ok(context, cleft_sizing_create(context, volume, left_out, &sizing[2]));
    const double whole = cleft_sizing_expected_tets(sizing[0]), inside = cleft_sizing_expected_tets(sizing[1]);
    assert_true(inside > 0 && inside < whole);
    assert_true(fabs(inside + cleft_sizing_expected_tets(sizing[2]) - whole) < 1e-6 * whole);
    for (int i = 0; i < 3; ++i)
        cleft_sizing_destroy(sizing[i]);
    cleft_options_destroy(left_out);
    cleft_options_destroy(kept);
    cleft_options_destroy(all);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void lists_are_checked_against_the_volume(void** state)
{
    static const int32_t all[3] = {-3, 7, 1000}, some[3] = {8, 1000, -1}, none[2] = {8, 9};
    warnings reported;
    cleft_context* context = listening_context(&reported);
    cleft_volume* volume = ball_volume(context, N);
    cleft_options* options = plain();
    cleft_mesh *mesh = NULL, *part = NULL;
    (void)state;
    assert_int_equal(cleft_options_set_strip(options, all, 3), CLEFT_OK);
    assert_fails(context, CLEFT_ERROR_OPTION, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    assert_null(mesh);
    assert_non_null(strstr(cleft_context_last_error(context), "strip would leave nothing of the volume"));
    assert_int_equal(cleft_options_set_strip(options, some, 3), CLEFT_OK);
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    assert_reported(&reported, "strip names labels -1 and 8, which the volume does not have");
    assert_int_equal(cleft_mesh_label_count(mesh), 2);
    assert_int_equal(cleft_options_set_strip(options, NULL, 0), CLEFT_OK);
    assert_int_equal(cleft_options_set_only(options, none, 2), CLEFT_OK);
    assert_fails(context, CLEFT_ERROR_OPTION, cleft_mesh_strip(context, mesh, options, &part));
    assert_null(part);
    assert_non_null(strstr(cleft_context_last_error(context), "only would leave nothing of the mesh"));
    assert_int_equal(cleft_options_set_only(options, all, 2), CLEFT_OK);
    assert_ok(context, cleft_mesh_strip(context, mesh, options, &part));
    assert_reported(&reported, NULL);
    assert_int_equal(cleft_options_set_only(options, all + 1, 2), CLEFT_OK);
    cleft_mesh_destroy(part);
    assert_ok(context, cleft_mesh_strip(context, mesh, options, &part));
    assert_reported(&reported, "only names label 1000, which the mesh does not have");
    assert_int_equal(cleft_mesh_label_count(part), 1);
    cleft_mesh_destroy(part);
    cleft_mesh_destroy(mesh);
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void a_mesh_without_a_kept_label_is_refused(void** state)
{
    const int64_t dims[3] = {24, 24, 24};
    const int32_t speck = 9;
    cleft_context* context = new_context();
    uint8_t* voxels = (uint8_t*)calloc(24 * 24 * 24, 1);
    cleft_volume* volume = NULL;
    cleft_options* options = plain();
    cleft_mesh* mesh = NULL;
    (void)state;
    voxels[12 + 24 * (12 + 24 * 12)] = 9;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, voxels, dims, NULL, NULL, &volume));
    assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SIZE, 11), CLEFT_OK);
    assert_int_equal(cleft_options_set_only(options, &speck, 1), CLEFT_OK);
    assert_fails(context, CLEFT_ERROR_LABEL_LOST, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    assert_null(mesh);
    free(voxels);
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_wanted_number_is_that_of_what_is_kept),
        cmocka_unit_test(a_number_that_would_fill_the_memory_is_not_met_and_told),
        cmocka_unit_test(a_sizing_field_expects_what_is_kept),
        cmocka_unit_test(lists_are_checked_against_the_volume),
        cmocka_unit_test(a_mesh_without_a_kept_label_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
