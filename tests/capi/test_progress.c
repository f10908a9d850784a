/* The progress of every long call never falls and ends at 1. */
#include "support/capi.h"

#include <string.h>

enum { N = 18 };

typedef struct {
    double last;
    int calls, faults;
    int cancels_at_end;
    cleft_context* asks; /* cancels at the end by a call, not by the answer */
} watch;

static int watching(double fraction, const char* stage, void* user)
{
    watch* w = (watch*)user;
    w->faults += !(fraction >= w->last && fraction <= 1) || !stage || !*stage;
    w->last = fraction;
    ++w->calls;
    if (w->asks && fraction >= 1)
        return cleft_context_cancel(w->asks) != CLEFT_OK;
    return w->cancels_at_end && fraction >= 1;
}

/* Asserts that the call succeeds with a progress that ends at 1. */
#define assert_whole(context, w, call)                                          \
    do {                                                                        \
        memset((w), 0, sizeof *(w));                                            \
        assert_ok(context, call);                                               \
        if ((w)->faults > 0 || (w)->calls == 0 || (w)->last != 1)               \
            fail_msg("%s: %d calls, last %.17g", #call, (w)->calls, (w)->last); \
    } while (0)

static void progress_of_every_stage_ends_at_one(void** state)
{
    const int64_t dims[3] = {N, N, N};
    watch w;
    cleft_context* context = new_context();
    int32_t* labels = ball_labels(N);
    float* values = (float*)malloc(sizeof(float) * N * N * N);
    const void* fields[2] = {values, labels};
    (void)state;
    assert_ok(context, cleft_context_set_progress(context, watching, &w));
    for (int v = 0; v < N * N * N; ++v)
        values[v] = labels[v] == 7 ? 3.0F : 2.5F;
    cleft_volume *volume = NULL, *functions = NULL;
    assert_whole(context, &w, cleft_volume_create_labels(context, CLEFT_TYPE_INT32, labels, dims, NULL, NULL, &volume));
    assert_whole(context, &w,
                 cleft_volume_create_indicators(context, CLEFT_TYPE_FLOAT32, fields, 1, dims, NULL, NULL, &functions));
    for (int32_t kind = 0; kind < 3; ++kind) {
        cleft_options* options = NULL;
        cleft_sizing *sizing = NULL, *own = NULL, *given = NULL, *constant = NULL;
        cleft_mesh *background = NULL, *cleaved = NULL, *improved = NULL, *stripped = NULL;
        cleft_estimate estimate = {.struct_size = sizeof estimate};
        cleft_surface* surface = NULL;
        cleft_report* report = NULL;
        cleft_quality quality = {.struct_size = sizeof quality};
        cleft_validation validation = {.struct_size = sizeof validation};
        assert_int_equal(cleft_options_create(&options), CLEFT_OK);
        assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_BACKGROUND, kind), CLEFT_OK);
        assert_whole(context, &w, cleft_sizing_create(context, volume, options, &sizing));
        assert_whole(context, &w,
                     cleft_sizing_create_values(context, volume, CLEFT_TYPE_FLOAT32, values, 1, options, &own));
        assert_whole(context, &w,
                     cleft_sizing_create_values(context, volume, CLEFT_TYPE_FLOAT32, values, 0, options, &given));
        assert_whole(context, &w, cleft_sizing_create_constant(context, volume, 3, &constant));
        assert_whole(context, &w, cleft_mesh_estimate(context, volume, constant, NULL, options, &estimate));
        assert_whole(context, &w, cleft_background_create(context, own, options, &background));
        assert_whole(context, &w, cleft_mesh_cleave(context, volume, background, options, &cleaved));
        assert_whole(context, &w, cleft_mesh_improve(context, volume, cleaved, options, &improved));
        assert_whole(context, &w, cleft_mesh_strip(context, improved, options, &stripped));
        assert_whole(context, &w, cleft_surface_create(context, improved, &surface));
        assert_whole(context, &w, cleft_report_create(context, volume, improved, &report));
        assert_whole(context, &w, cleft_mesh_quality(context, improved, &quality));
        assert_whole(context, &w, cleft_mesh_validate(context, improved, 1, &validation));
        cleft_report_destroy(report);
        cleft_surface_destroy(surface);
        cleft_mesh_destroy(stripped);
        cleft_mesh_destroy(improved);
        cleft_mesh_destroy(cleaved);
        cleft_mesh_destroy(background);
        cleft_sizing_destroy(constant);
        cleft_sizing_destroy(given);
        cleft_sizing_destroy(own);
        cleft_sizing_destroy(sizing);
        cleft_options_destroy(options);
    }
    free(values);
    free(labels);
    cleft_volume_destroy(functions);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void progress_of_meshing_ends_at_one(void** state)
{
    enum { PLAIN, TETS, STRIP, STRIP_AND_TETS, STRICT, SIZING, BACKGROUND, OFF, WAYS };
    const int32_t outside = 1000;
    watch w;
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, N);
    cleft_sizing* sizing = NULL;
    cleft_mesh* background = NULL;
    (void)state;
    assert_ok(context, cleft_sizing_create_constant(context, volume, 3, &sizing));
    assert_ok(context, cleft_background_create(context, sizing, NULL, &background));
    assert_ok(context, cleft_context_set_progress(context, watching, &w));
    for (int32_t kind = 0; kind < 3; ++kind)
        for (int way = 0; way < WAYS; ++way) {
            cleft_options* options = NULL;
            cleft_mesh* mesh = NULL;
            const int wants = way == TETS || way == STRIP_AND_TETS, strips = way == STRIP || way == STRIP_AND_TETS;
            assert_int_equal(cleft_options_create(&options), CLEFT_OK);
            assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_BACKGROUND, kind), CLEFT_OK);
            assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_TETS, wants ? 9000 : 0), CLEFT_OK);
            assert_int_equal(cleft_options_set_strip(options, &outside, strips), CLEFT_OK);
            assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_STRICT, way == STRICT), CLEFT_OK);
            if (way == OFF)
                assert_int_equal(cleft_options_set_text(options, "improve", "off"), CLEFT_OK);
            assert_whole(context, &w,
                         cleft_mesh_volume(context, volume, way == SIZING ? sizing : NULL,
                                           way == BACKGROUND ? background : NULL, options, &mesh));
            cleft_mesh_destroy(mesh);
            cleft_options_destroy(options);
        }
    cleft_mesh_destroy(background);
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void a_call_may_be_cancelled_at_its_very_end(void** state)
{
    watch w = {0};
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, N);
    cleft_mesh* mesh = NULL;
    (void)state;
    w.cancels_at_end = 1;
    assert_ok(context, cleft_context_set_progress(context, watching, &w));
    assert_fails(context, CLEFT_ERROR_CANCELLED, cleft_mesh_volume(context, volume, NULL, NULL, NULL, &mesh));
    assert_null(mesh);
    w = (watch){.asks = context};
    assert_fails(context, CLEFT_ERROR_CANCELLED, cleft_mesh_volume(context, volume, NULL, NULL, NULL, &mesh));
    assert_null(mesh);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(progress_of_every_stage_ends_at_one),
        cmocka_unit_test(progress_of_meshing_ends_at_one),
        cmocka_unit_test(a_call_may_be_cancelled_at_its_very_end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
