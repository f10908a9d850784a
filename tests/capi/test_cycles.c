/* Memory stays flat over 1,000 cycles of making everything and giving it back, with calls that fail among them. */
#include "support/capi.h"

#include <stdio.h>

enum { SIDE = 4, VOXELS = SIDE * SIDE * SIDE };

static int go_on(double fraction, const char* stage, void* user)
{
    (void)fraction, (void)stage, (void)user;
    return 0;
}

static int cancel(double fraction, const char* stage, void* user)
{
    (void)fraction, (void)stage, (void)user;
    return 1;
}

static void make_and_destroy(void)
{
    uint8_t voxels[VOXELS];
    const int64_t dims[3] = {SIDE, SIDE, SIDE};
    const double nowhere[12] = {0};
    cleft_context* context = NULL;
    cleft_options* options = NULL;
    cleft_volume *volume = NULL, *none = NULL;
    cleft_sizing* sizing = NULL;
    cleft_mesh *mesh = NULL, *copy = NULL, *cancelled = NULL;
    cleft_surface* surface = NULL;
    cleft_report* report = NULL;
    for (int v = 0; v < VOXELS; ++v)
        voxels[v] = v / (VOXELS / 2) != 0;

    assert_int_equal(cleft_context_create(&context), CLEFT_OK);
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "background", "lattice"), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "gradation", "7"), CLEFT_ERROR_OPTION);
    assert_int_equal(cleft_context_set_progress(context, go_on, NULL), CLEFT_OK);
    assert_int_equal(cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, voxels, dims, NULL, options, &volume),
                     CLEFT_OK);
    assert_int_not_equal(cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, voxels, dims, nowhere, options, &none),
                         CLEFT_OK);
    assert_int_equal(cleft_sizing_create_constant(context, volume, 2, &sizing), CLEFT_OK);
    assert_int_equal(cleft_mesh_volume(context, volume, sizing, NULL, options, &mesh), CLEFT_OK);
    assert_int_equal(cleft_mesh_create(context, cleft_mesh_point_count(mesh), cleft_mesh_points(mesh),
                                       cleft_mesh_tet_count(mesh), cleft_mesh_tets(mesh), NULL, 0, &copy),
                     CLEFT_OK);
    assert_int_equal(cleft_surface_create(context, mesh, &surface), CLEFT_OK);
    assert_int_equal(cleft_report_create(context, volume, mesh, &report), CLEFT_OK);
    assert_int_equal(cleft_context_set_progress(context, cancel, NULL), CLEFT_OK);
    assert_int_equal(cleft_mesh_volume(context, volume, sizing, NULL, options, &cancelled), CLEFT_ERROR_CANCELLED);
    assert_null(cancelled);

    cleft_report_destroy(report);
    cleft_surface_destroy(surface);
    cleft_mesh_destroy(copy);
    cleft_mesh_destroy(mesh);
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
    cleft_options_destroy(options);
    cleft_context_destroy(context);
}

/* 0 where it is not known: no such file, or a sanitizer, which keeps what was freed (and looks for leaks itself). */
static long resident_kilobytes(void)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return 0;
#else
    char line[200];
    long kilobytes = 0;
    FILE* status = fopen("/proc/self/status", "r");
    if (!status)
        return 0;
    while (fgets(line, sizeof line, status))
        if (sscanf(line, "VmRSS: %ld", &kilobytes) == 1)
            break;
    fclose(status);
    return kilobytes;
#endif
}

static void memory_is_flat(void** state)
{
    (void)state;
    for (int i = 0; i < 200; ++i)
        make_and_destroy();
    const long before = resident_kilobytes();
    for (int i = 0; i < 1000; ++i)
        make_and_destroy();
    if (before == 0)
        skip();
    assert_in_range(resident_kilobytes(), 1, before + 2000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(memory_is_flat)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
