/* Programs that were built before a struct of the file component grew, and after it will have grown further. What the
 * structs were is in abi/first_structs.h. */
#include "abi/first_structs.h"
#include "cleft/cleft_io.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

enum { VOXELS = 2 * 3 * 4 };

typedef struct {
    cleft_context* context;
    char path[32];
} fixture;

static int set_up(void** state)
{
    static unsigned char voxels[VOXELS] = {1, 1, 1, 1};
    fixture* f = calloc(1, sizeof *f);
    strcpy(f->path, "/tmp/cleft_ages_XXXXXX");
    *state = f;
    const int file = mkstemp(f->path);
    const int is_written = file >= 0 && write(file, voxels, VOXELS) == VOXELS && close(file) == 0;
    return is_written && cleft_context_create(&f->context) == CLEFT_OK ? 0 : -1;
}

static int tear_down(void** state)
{
    fixture* f = *state;
    cleft_context_destroy(f->context);
    const int removed = unlink(f->path);
    free(f);
    return removed;
}

static cleft_status read_raw(fixture* f, const void* raw, double affine[12])
{
    const char* path = f->path;
    cleft_volume* volume = NULL;
    const cleft_status status = cleft_io_read_raw(f->context, NULL, &path, 1, raw, &volume);
    assert_true((status == CLEFT_OK) == (volume != NULL));
    if (volume)
        assert_int_equal(cleft_volume_affine(volume, affine), CLEFT_OK);
    cleft_volume_destroy(volume);
    return status;
}

static void raw_layouts_of_all_ages_are_read(void** state)
{
    fixture* f = *state;
    const first_io_raw older = {
        .struct_size = sizeof older, .type = CLEFT_TYPE_UINT8, .dims = {2, 3, 4}, .spacing = {1, 2, 3}};
    struct {
        cleft_io_raw known;
        int64_t later;
    } newer = {{.struct_size = sizeof newer, .type = CLEFT_TYPE_UINT8, .dims = {2, 3, 4}, .spacing = {1, 2, 3}}, 0};
    double affine[12] = {0};
    assert_int_equal(read_raw(f, &older, affine), CLEFT_OK);
    assert_true(affine[0] == 1 && affine[5] == 2 && affine[10] == 3);
    assert_int_equal(read_raw(f, &newer, affine), CLEFT_OK);
    assert_true(affine[0] == 1 && affine[5] == 2 && affine[10] == 3);
    newer.later = INT64_MIN; /* its last byte alone is not 0 */
    assert_int_equal(read_raw(f, &newer, affine), CLEFT_ERROR_ARGUMENT);
    assert_string_equal(cleft_context_last_error(f->context),
                        "the cleft_io_raw has a field set that this version of the library does not know");
}

static cleft_status read_values(fixture* f, const char* path, const void* reading, double affine[12])
{
    double* values = NULL;
    int64_t dims[3];
    const cleft_status status = cleft_io_read_field(f->context, path, reading, dims, affine, &values);
    assert_true((status == CLEFT_OK) == (values != NULL));
    cleft_io_free(values);
    return status;
}

static void write_nrrd(const char* path)
{
    FILE* file = fopen(path, "w");
    assert_non_null(file);
    fputs("NRRD0004\ntype: uint8\ndimension: 3\nsizes: 1 1 2\nspacings: 1 1 1\nencoding: ascii\n\n1 2\n", file);
    fclose(file);
}

static void readings_of_all_ages_are_followed(void** state)
{
    fixture* f = *state;
    char path[40];
    /* Without a scale, as its size ends before it: what lies beyond is not read. */
    struct {
        first_io_reading known;
        double beyond;
    } older = {{.struct_size = sizeof older.known, .world = CLEFT_IO_WORLD_RAS, .spacing = {0, 0, 3}}, -7};
    struct {
        cleft_io_reading known;
        int64_t later[2];
    } newer = {{.struct_size = sizeof newer, .spacing = {0, 0, 3}, .scale = 2}, {0, 0}};
    double affine[12] = {0};
    snprintf(path, sizeof path, "%s.nrrd", f->path);
    write_nrrd(path);
    assert_int_equal(read_values(f, path, &older, affine), CLEFT_OK);
    assert_true(affine[10] == 3);
    assert_int_equal(read_values(f, path, &newer, affine), CLEFT_OK);
    assert_true(affine[10] == 3 && affine[5] == 2);
    newer.known.reserved = 1;
    assert_int_equal(read_values(f, path, &newer, affine), CLEFT_ERROR_ARGUMENT);
    assert_string_equal(cleft_context_last_error(f->context), "reserved of the cleft_io_reading is 1; it must be 0");
    newer.known.reserved = 0;
    newer.later[1] = 1;
    assert_int_equal(read_values(f, path, &newer, affine), CLEFT_ERROR_ARGUMENT);
    assert_string_equal(cleft_context_last_error(f->context),
                        "the cleft_io_reading has a field set that this version of the library does not know");
    assert_int_equal(unlink(path), 0);
}

static void views_of_all_ages_are_written(void** state)
{
    fixture* f = *state;
    static const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const int32_t tet[] = {0, 1, 2, 3};
    cleft_mesh* mesh = NULL;
    assert_int_equal(cleft_mesh_create(f->context, 4, points, 1, tet, NULL, 0, &mesh), CLEFT_OK);
    const first_io_view older = {.struct_size = sizeof older, .title = "a", .other = mesh};
    struct {
        cleft_io_view known;
        int64_t later;
    } newer = {{.struct_size = sizeof newer, .title = "a"}, 0};
    char path[40];
    snprintf(path, sizeof path, "%s.html", f->path);
    assert_int_equal(cleft_io_write_view(f->context, mesh, (const cleft_io_view*)&older, path), CLEFT_OK);
    assert_int_equal(cleft_io_write_view(f->context, mesh, &newer.known, path), CLEFT_OK);
    newer.later = 1;
    assert_int_equal(cleft_io_write_view(f->context, mesh, &newer.known, path), CLEFT_ERROR_ARGUMENT);
    assert_string_equal(cleft_context_last_error(f->context),
                        "the cleft_io_view has a field set that this version of the library does not know");
    assert_int_equal(unlink(path), 0);
    cleft_mesh_destroy(mesh);
}

static void pictures_of_all_ages_are_drawn(void** state)
{
    fixture* f = *state;
    static const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const int32_t tet[] = {0, 1, 2, 3};
    cleft_mesh* mesh = NULL;
    assert_int_equal(cleft_mesh_create(f->context, 4, points, 1, tet, NULL, 0, &mesh), CLEFT_OK);
    const first_io_picture older = {.struct_size = sizeof older, .width = 8, .height = 8};
    struct {
        cleft_io_picture known;
        int64_t later;
    } newer = {{.struct_size = sizeof newer, .width = 8, .height = 8}, 0};
    char path[40];
    snprintf(path, sizeof path, "%s.png", f->path);
    assert_int_equal(cleft_io_write_picture(f->context, mesh, NULL, 0, NULL, 0, (const cleft_io_picture*)&older, path),
                     CLEFT_OK);
    assert_int_equal(cleft_io_write_picture(f->context, mesh, NULL, 0, NULL, 0, &newer.known, path), CLEFT_OK);
    newer.later = 1;
    assert_int_equal(cleft_io_write_picture(f->context, mesh, NULL, 0, NULL, 0, &newer.known, path),
                     CLEFT_ERROR_ARGUMENT);
    assert_string_equal(cleft_context_last_error(f->context),
                        "the cleft_io_picture has a field set that this version of the library does not know");
    assert_int_equal(unlink(path), 0);
    cleft_mesh_destroy(mesh);
}

static void rows_of_formats_go_to_all_ages(void** state)
{
    struct {
        cleft_io_format_description known;
        int64_t later;
    } newer;
    first_io_format_description older;
    (void)state;
    for (int32_t index = 0; index < cleft_io_format_count(); ++index) {
        cleft_io_format_description now = {.struct_size = sizeof now};
        assert_int_equal(cleft_io_format_info(index, &now), CLEFT_OK);
        memset(&older, 0x55, sizeof older);
        older.struct_size = sizeof older;
        assert_int_equal(cleft_io_format_info(index, (cleft_io_format_description*)&older), CLEFT_OK);
        assert_int_equal(older.struct_size, sizeof older);
        assert_int_equal(older.format, now.format);
        assert_int_equal(older.directions, now.directions);
        assert_string_equal(older.name, now.name);
        assert_string_equal(older.extensions, now.extensions);
        assert_string_equal(older.text, now.text);
        memset(&newer, 0x55, sizeof newer);
        newer.known.struct_size = sizeof newer;
        assert_int_equal(cleft_io_format_info(index, &newer.known), CLEFT_OK);
        assert_string_equal(newer.known.text, now.text);
        assert_int_equal(newer.later, 0x5555555555555555);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(raw_layouts_of_all_ages_are_read, set_up, tear_down),
        cmocka_unit_test_setup_teardown(readings_of_all_ages_are_followed, set_up, tear_down),
        cmocka_unit_test_setup_teardown(views_of_all_ages_are_written, set_up, tear_down),
        cmocka_unit_test_setup_teardown(pictures_of_all_ages_are_drawn, set_up, tear_down),
        cmocka_unit_test(rows_of_formats_go_to_all_ages),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
