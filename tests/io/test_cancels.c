/* Pictures and pages that are cancelled: at each report of their progress, and by another call. No file remains. */
#include "io/folder_fixture.h"
#include "io/sample_mesh.h"

#include <unistd.h>

typedef struct listener {
    cleft_context* context;
    int calls;
    int last; /* the call that cancels; 0: none */
    int by_answer;
    double fraction;
    char stages[2000];
} listener;

static int listen(double fraction, const char* stage, void* user)
{
    listener* l = user;
    assert_true(fraction >= l->fraction && fraction <= 1);
    l->fraction = fraction;
    if (!strstr(l->stages, stage))
        strncat(strncat(l->stages, stage, 100), ";", 2);
    /* The context is the call's. */
    assert_int_equal(cleft_context_set_threads(l->context, 1), CLEFT_ERROR_BUSY);
    if (++l->calls != l->last)
        return 0;
    return l->by_answer || cleft_context_cancel(l->context) != CLEFT_OK;
}

typedef cleft_status (*writer)(fixture* f, const cleft_mesh* mesh);

static cleft_status write_picture(fixture* f, const cleft_mesh* mesh)
{
    const cleft_io_picture look = {.struct_size = sizeof look, .width = 300, .height = 200, .legend = 1};
    return cleft_io_write_picture(f->context, mesh, NULL, 0, NULL, 0, &look, path_of(f, "file.png"));
}

static cleft_status write_page(fixture* f, const cleft_mesh* mesh)
{
    /* So few tetrahedra that the surface is looked for. */
    const cleft_io_view view = {.struct_size = sizeof view, .max_tets = 100, .other = mesh};
    return cleft_io_write_view(f->context, mesh, &view, path_of(f, "file.html"));
}

static int is_empty(fixture* f)
{
    char command[128];
    snprintf(command, sizeof command, "test -z \"$(ls -A %s)\"", f->folder);
    return system(command) == 0;
}

static void cancel_everywhere(fixture* f, writer write, const char* const* stages)
{
    cleft_mesh* mesh = sample_mesh_create(f->context);
    assert_non_null(mesh);
    listener l = {.context = f->context};
    assert_int_equal(cleft_context_set_progress(f->context, listen, &l), CLEFT_OK);
    assert_int_equal(write(f, mesh), CLEFT_OK);
    assert_true(l.fraction == 1);
    for (; *stages; ++stages)
        assert_non_null(strstr(l.stages, *stages));
    unlink(f->path);
    /* How many reports there are depends on the time that a call takes: it is cancelled until it comes to its end. */
    cleft_status status = CLEFT_ERROR_CANCELLED;
    for (int last = 1; status != CLEFT_OK; ++last) {
        l = (listener){.context = f->context, .last = last, .by_answer = last % 2};
        status = write(f, mesh);
        assert_int_equal(status, l.calls < last ? CLEFT_OK : CLEFT_ERROR_CANCELLED);
        assert_int_equal(is_empty(f), status != CLEFT_OK);
        assert_int_equal(strlen(cleft_context_last_error(f->context)) > 5, status != CLEFT_OK);
    }
    cleft_mesh_destroy(mesh);
}

static void pictures_can_be_cancelled(void** state)
{
    static const char* const stages[] = {"picture: faces;",   "picture: colours;",     "picture: drawing;",
                                         "picture: creases;", "picture: compressing;", NULL};
    cancel_everywhere(*state, write_picture, stages);
}

static void pages_can_be_cancelled(void** state)
{
    static const char* const stages[] = {"extracting interfaces;", "measuring quality;", "page: figures;",
                                         "page: tetrahedra;",      "page: packing;",     NULL};
    cancel_everywhere(*state, write_page, stages);
}

/* Without a callback, a cancel from elsewhere is seen; here it is asked for before the call of a component. */
static void a_cancel_is_seen_without_a_callback(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = sample_mesh_create(f->context);
    const writer writers[] = {write_picture, write_page};
    for (int i = 0; i < 2; ++i) {
        assert_int_equal(cleft_context_begin(f->context, NULL, 0), CLEFT_OK);
        assert_int_equal(cleft_context_cancel(f->context), CLEFT_OK);
        assert_int_equal(writers[i](f, mesh), CLEFT_ERROR_CANCELLED);
        cleft_context_end(f->context);
        assert_true(is_empty(f));
        assert_int_equal(writers[i](f, mesh), CLEFT_OK);
        unlink(f->path);
    }
    cleft_mesh_destroy(mesh);
}

int main(void)
{
#define CASE(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        CASE(pictures_can_be_cancelled),
        CASE(pages_can_be_cancelled),
        CASE(a_cancel_is_seen_without_a_callback),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
