/* Callbacks that destroy what their call works with, and contexts that are asked for two things at once (threads too).
 */
#include "support/capi.h"

#include <math.h>
#include <pthread.h>
#include <stdbool.h>
#include <string.h>

enum { N = 12 };

typedef struct handles {
    cleft_context* context;
    cleft_options* options;
    cleft_volume* volume;
    cleft_sizing* sizing;
    cleft_mesh* mesh;
    cleft_mesh* background;
    int calls;
} handles;

static handles all_handles(void)
{
    static const int32_t strip[2] = {1000, 99}; /* the second is not there: a warning */
    handles h = {.context = new_context()};
    h.volume = ball_volume(h.context, N);
    assert_int_equal(cleft_options_create(&h.options), CLEFT_OK);
    assert_int_equal(cleft_options_set_integer(h.options, CLEFT_OPTION_BACKGROUND, CLEFT_BACKGROUND_LATTICE), CLEFT_OK);
    assert_int_equal(cleft_options_set_strip(h.options, strip, 2), CLEFT_OK);
    assert_ok(h.context, cleft_sizing_create_constant(h.context, h.volume, 2, &h.sizing));
    assert_ok(h.context, cleft_background_create(h.context, h.sizing, h.options, &h.background));
    assert_ok(h.context, cleft_mesh_cleave(h.context, h.volume, h.background, h.options, &h.mesh));
    return h;
}

static void destroy_all(handles* h)
{
    cleft_mesh_destroy(h->background);
    cleft_mesh_destroy(h->mesh);
    cleft_sizing_destroy(h->sizing);
    cleft_volume_destroy(h->volume);
    cleft_options_destroy(h->options);
    cleft_context_destroy(h->context);
    h->background = h->mesh = NULL;
    h->sizing = NULL;
    h->volume = NULL;
    h->options = NULL;
    h->context = NULL;
}

static int destroying(double fraction, const char* stage, void* user)
{
    handles* h = user;
    (void)fraction;
    (void)stage;
    if (h->calls++ == 0)
        destroy_all(h);
    return 0;
}

/* Before a call has done anything: it warns of its options first. */
static void destroying_at_a_warning(int32_t level, const char* sentence, void* user)
{
    (void)sentence;
    if (level == CLEFT_LOG_WARNING)
        destroying(0, NULL, user);
}

/* Each entry that calls back, by number; -1 if there are no more. */
static cleft_status run_entry(int entry, handles h, void** out)
{
    cleft_quality quality = {.struct_size = sizeof quality};
    cleft_validation validation = {.struct_size = sizeof validation};
    switch (entry) {
        case 0:
            return cleft_sizing_create(h.context, h.volume, h.options, (cleft_sizing**)out);
        case 1:
            return cleft_background_create(h.context, h.sizing, h.options, (cleft_mesh**)out);
        case 2:
            return cleft_mesh_cleave(h.context, h.volume, h.background, h.options, (cleft_mesh**)out);
        case 3:
            return cleft_mesh_improve(h.context, h.volume, h.mesh, h.options, (cleft_mesh**)out);
        case 4:
            return cleft_mesh_volume(h.context, h.volume, NULL, NULL, h.options, (cleft_mesh**)out);
        case 5:
            return cleft_mesh_volume(h.context, h.volume, h.sizing, NULL, h.options, (cleft_mesh**)out);
        case 6:
            return cleft_mesh_volume(h.context, h.volume, NULL, h.background, h.options, (cleft_mesh**)out);
        case 7:
            return cleft_surface_create(h.context, h.mesh, (cleft_surface**)out);
        case 8:
            return cleft_report_create(h.context, h.volume, h.mesh, (cleft_report**)out);
        case 9:
            return cleft_mesh_validate(h.context, h.mesh, 1, &validation);
        case 10:
            return cleft_mesh_quality(h.context, h.mesh, &quality);
        default:
            return CLEFT_STATUS_RESERVED;
    }
}

static void destroy_made(int entry, void* made)
{
    if (entry == 0)
        cleft_sizing_destroy((cleft_sizing*)made);
    else if (entry <= 6)
        cleft_mesh_destroy((cleft_mesh*)made);
    else if (entry == 7)
        cleft_surface_destroy((cleft_surface*)made);
    else
        cleft_report_destroy((cleft_report*)made);
}

static void run_all_entries(bool at_warnings, int least_called)
{
    int called = 0;
    for (int entry = 0;; ++entry) {
        handles h = all_handles();
        void* made = NULL;
        assert_int_equal(cleft_options_set_integer(h.options, CLEFT_OPTION_SMOOTH, 4), CLEFT_OK);
        if (at_warnings)
            assert_ok(h.context, cleft_context_set_log(h.context, destroying_at_a_warning, &h));
        else
            assert_ok(h.context, cleft_context_set_progress(h.context, destroying, &h));
        const cleft_status status = run_entry(entry, h, &made);
        called += h.calls > 0;
        if (h.calls == 0)
            destroy_all(&h);
        if (status == CLEFT_STATUS_RESERVED)
            break;
        assert_int_equal(status, CLEFT_OK);
        assert_true(entry > 8 || made);
        destroy_made(entry, made);
    }
    assert_true(called >= least_called);
}

static void what_a_callback_destroys_lives_until_the_call_ends(void** state)
{
    (void)state;
    run_all_entries(false, 9);
    run_all_entries(true, 6);
}

static int trying(double fraction, const char* stage, void* user)
{
    handles* h = user;
    cleft_mesh* mesh = NULL;
    cleft_quality quality = {.struct_size = sizeof quality};
    const char* name = NULL;
    double value = 0;
    (void)fraction;
    (void)stage;
    ++h->calls;
    assert_int_equal(cleft_mesh_quality(h->context, h->mesh, &quality), CLEFT_ERROR_BUSY);
    assert_int_equal(cleft_mesh_strip(h->context, h->mesh, h->options, &mesh), CLEFT_ERROR_BUSY);
    assert_null(mesh);
    assert_int_equal(cleft_context_set_threads(h->context, 2), CLEFT_ERROR_BUSY);
    assert_int_equal(cleft_context_set_progress(h->context, NULL, NULL), CLEFT_ERROR_BUSY);
    assert_int_equal(cleft_context_set_log(h->context, NULL, NULL), CLEFT_ERROR_BUSY);
    assert_int_equal(cleft_context_clear_metrics(h->context), CLEFT_ERROR_BUSY);
    assert_int_equal(cleft_context_log(h->context, CLEFT_LOG_INFO, "no"), CLEFT_ERROR_BUSY);
    assert_int_equal(cleft_context_set_error(h->context, CLEFT_ERROR_FILE, "no"), CLEFT_ERROR_BUSY);
    assert_int_equal(cleft_context_begin(h->context, NULL, 0), CLEFT_ERROR_BUSY);
    assert_int_equal(cleft_context_report(h->context, 0, 1, "no"), CLEFT_ERROR_BUSY);
    /* what a callback may do */
    assert_int_equal(cleft_context_threads(h->context), 1);
    assert_string_equal(cleft_context_last_error(h->context), "");
    for (int64_t i = 0; i < cleft_context_metric_count(h->context); ++i)
        assert_int_equal(cleft_context_metric(h->context, i, &name, &value), CLEFT_OK);
    return h->calls > 3 && cleft_context_cancel(h->context) != CLEFT_OK;
}

static void a_callback_cannot_use_the_context_of_its_call(void** state)
{
    handles h = all_handles();
    cleft_mesh* mesh = NULL;
    (void)state;
    assert_ok(h.context, cleft_context_set_progress(h.context, trying, &h));
    assert_fails(h.context, CLEFT_ERROR_CANCELLED,
                 cleft_mesh_volume(h.context, h.volume, NULL, NULL, h.options, &mesh));
    assert_true(h.calls > 3);
    /* the context is free again */
    assert_ok(h.context, cleft_context_set_progress(h.context, NULL, NULL));
    assert_ok(h.context, cleft_mesh_volume(h.context, h.volume, NULL, NULL, h.options, &mesh));
    cleft_mesh_destroy(mesh);
    destroy_all(&h);
}

static void* use_from_another_thread(void* user)
{
    handles* h = user;
    cleft_quality quality = {.struct_size = sizeof quality};
    const char* name = NULL;
    double value = 0;
    assert_int_equal(cleft_mesh_quality(h->context, h->mesh, &quality), CLEFT_ERROR_BUSY);
    assert_int_equal(cleft_context_set_threads(h->context, 2), CLEFT_ERROR_BUSY);
    assert_int_equal(cleft_context_metric(h->context, 0, &name, &value), CLEFT_ERROR_BUSY);
    assert_int_equal(cleft_context_metric_count(h->context), 0);
    assert_string_equal(cleft_context_last_error(h->context), "");
    assert_int_equal(cleft_context_cancel(h->context), CLEFT_OK);
    return NULL;
}

static int asking_a_thread(double fraction, const char* stage, void* user)
{
    handles* h = user;
    pthread_t thread;
    (void)fraction;
    (void)stage;
    if (h->calls++ == 0) {
        assert_int_equal(pthread_create(&thread, NULL, use_from_another_thread, h), 0);
        assert_int_equal(pthread_join(thread, NULL), 0);
    }
    return 0;
}

static void another_thread_cannot_use_a_context_meanwhile(void** state)
{
    handles h = all_handles();
    cleft_mesh* mesh = NULL;
    (void)state;
    assert_ok(h.context, cleft_context_set_progress(h.context, asking_a_thread, &h));
    assert_fails(h.context, CLEFT_ERROR_CANCELLED,
                 cleft_mesh_volume(h.context, h.volume, NULL, NULL, h.options, &mesh));
    assert_int_equal(h.calls, 1);
    destroy_all(&h);
}

static void a_component_has_the_context_to_itself(void** state)
{
    handles h = all_handles();
    cleft_quality quality = {.struct_size = sizeof quality};
    const void* const kept[] = {h.mesh, NULL, h.options};
    const int none = 0;
    const void* const bad[] = {h.mesh, &none};
    pthread_t thread;
    (void)state;
    assert_fails(h.context, CLEFT_ERROR_HANDLE, cleft_context_begin(h.context, bad, 2));
    assert_ok(h.context, cleft_context_begin(h.context, kept, 3));
    assert_ok(h.context, cleft_context_begin(h.context, NULL, 0)); /* a component of the component */
    cleft_context_end(h.context);
    assert_ok(h.context, cleft_context_cancel(h.context));
    assert_fails(h.context, CLEFT_ERROR_CANCELLED, cleft_mesh_quality(h.context, h.mesh, &quality));
    assert_int_equal(pthread_create(&thread, NULL, use_from_another_thread, &h), 0);
    assert_int_equal(pthread_join(thread, NULL), 0);
    cleft_context_end(h.context);
    cleft_context_end(h.context); /* one too many */
    assert_ok(h.context, cleft_mesh_quality(h.context, h.mesh, &quality));
    assert_ok(h.context, cleft_context_begin(h.context, kept, 3));
    cleft_context* context = h.context;
    const cleft_mesh* mesh = h.mesh;
    destroy_all(&h);
    assert_true(cleft_mesh_tet_count(mesh) > 0);
    assert_ok(context, cleft_mesh_quality(context, mesh, &quality));
    cleft_context_end(context);
}

typedef struct heard {
    double fractions[1000];
    const char* stages[1000];
    int count;
} heard;

static int hear(double fraction, const char* stage, void* user)
{
    heard* h = user;
    assert_true(h->count < 1000);
    h->fractions[h->count] = fraction;
    h->stages[h->count++] = strstr(stage, "mine") ? "mine" : "of the library";
    return strcmp(stage, "mine no more") == 0;
}

static void a_component_tells_how_far_it_is(void** state)
{
    handles h = all_handles();
    cleft_quality quality = {.struct_size = sizeof quality};
    heard so_far = {.count = 0};
    (void)state;
    assert_ok(h.context, cleft_context_set_progress(h.context, hear, &so_far));
    assert_ok(h.context, cleft_context_begin(h.context, NULL, 0));
    assert_ok(h.context, cleft_context_report(h.context, 0.25, 0.5, "mine"));
    assert_ok(h.context, cleft_mesh_quality(h.context, h.mesh, &quality));
    assert_ok(h.context, cleft_context_report(h.context, 0.5, 0.5, "mine"));
    assert_ok(h.context, cleft_mesh_quality(h.context, h.mesh, &quality));
    const int count = so_far.count;
    assert_true(count > 3 && so_far.fractions[0] == 0.25 && so_far.fractions[count - 1] == 0.5);
    for (int i = 1; i < count; ++i)
        assert_true(so_far.fractions[i] >= so_far.fractions[i - 1]);
    assert_string_equal(so_far.stages[0], "mine");
    assert_string_equal(so_far.stages[1], "of the library");
    /* The callback, and a request, cancel. */
    assert_fails(h.context, CLEFT_ERROR_CANCELLED, cleft_context_report(h.context, 0.5, 1, "mine no more"));
    assert_ok(h.context, cleft_context_report(h.context, 0.5, 1, "mine"));
    assert_ok(h.context, cleft_context_cancel(h.context));
    assert_fails(h.context, CLEFT_ERROR_CANCELLED, cleft_context_report(h.context, 0.5, 1, "mine"));
    assert_fails(h.context, CLEFT_ERROR_ARGUMENT, cleft_context_report(h.context, 0.5, 0.4, "mine"));
    assert_fails(h.context, CLEFT_ERROR_ARGUMENT, cleft_context_report(h.context, -0.1, 0.4, "mine"));
    assert_fails(h.context, CLEFT_ERROR_ARGUMENT, cleft_context_report(h.context, 0, NAN, "mine"));
    assert_fails(h.context, CLEFT_ERROR_NULL, cleft_context_report(h.context, 0, 1, NULL));
    assert_int_equal(cleft_context_report(NULL, 0, 1, "mine"), CLEFT_ERROR_NULL);
    cleft_context_end(h.context);
    /* The next call is a whole again. */
    so_far.count = 0;
    assert_ok(h.context, cleft_mesh_quality(h.context, h.mesh, &quality));
    assert_true(so_far.fractions[0] == 0);
    destroy_all(&h);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_a_callback_destroys_lives_until_the_call_ends),
        cmocka_unit_test(a_callback_cannot_use_the_context_of_its_call),
        cmocka_unit_test(another_thread_cannot_use_a_context_meanwhile),
        cmocka_unit_test(a_component_has_the_context_to_itself),
        cmocka_unit_test(a_component_tells_how_far_it_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
