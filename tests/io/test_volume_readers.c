/* NRRD, MetaImage and legacy VTK: every type of voxels in every encoding and order of bytes, and files that are cut
 * short at every byte, each of which must be refused. */
#include "written_volumes.h"

static void check_labels(fixture* f, const type* t, double offset)
{
    cleft_volume* volume = NULL;
    if (read_labels(f, &volume) != CLEFT_OK)
        fail_msg("%.*s\n%s", 200, (const char*)f->bytes, cleft_context_last_error(f->context));
    for (int v = 0; v < VOXELS; ++v) {
        const double centre[3] = {v % NX + offset, v / NX % NY + offset, v / (NX * NY) + offset};
        int32_t label = -1;
        assert_int_equal(cleft_volume_sample(volume, centre, 1, &label), CLEFT_OK);
        assert_int_equal(label, label_of(t, v));
    }
    cleft_volume_destroy(volume);
}

/* The next of the names that '|' separates, "" at the end. */
static const char* next_name(const char* names, char* name)
{
    const size_t length = strcspn(names, "|");
    memcpy(name, names, length);
    name[length] = '\0';
    return names + length + (names[length] == '|');
}

static void test_every_nrrd(void** state)
{
    fixture* f = *state;
    char name[64];
    for (size_t i = 0; i < sizeof types / sizeof *types; ++i)
        for (const char* names = next_name(types[i].nrrd, name); *name; names = next_name(names, name))
            for (encoding how = RAW; how <= HEX; ++how)
                for (int big_endian = 0; big_endian < 2; ++big_endian) {
                    put_nrrd(f, &types[i], name, how, big_endian);
                    store(f, "a.nrrd", f->size);
                    check_labels(f, &types[i], 0);
                }
}

static void test_every_metaimage(void** state)
{
    fixture* f = *state;
    char name[64];
    for (size_t i = 0; i < sizeof types / sizeof *types; ++i)
        for (const char* names = next_name(types[i].meta, name); *name; names = next_name(names, name))
            for (encoding how = RAW; how <= TEXT; ++how)
                for (int big_endian = 0; big_endian < 2; ++big_endian) {
                    put_meta(f, &types[i], name, how, big_endian);
                    store(f, "a.mha", f->size);
                    check_labels(f, &types[i], 0);
                }
}

static void test_every_vtk(void** state)
{
    fixture* f = *state;
    char name[64];
    for (size_t i = 0; i < sizeof types / sizeof *types; ++i)
        for (const char* names = next_name(types[i].vtk, name); *name; names = next_name(names, name))
            for (int text = 0; text < 2; ++text)
                for (int on_cells = 0; on_cells < 2; ++on_cells) {
                    put_vtk(f, &types[i], name, text ? TEXT : RAW, on_cells);
                    store(f, "a.vtk", f->size);
                    check_labels(f, &types[i], on_cells ? 0.5 : 0);
                }
}

/* Each beginning of a file that is whole is refused. */
static void refuse_all_beginnings(fixture* f, const char* name)
{
    for (size_t size = 0; size < f->size; ++size) {
        cleft_volume* volume = NULL;
        store(f, name, size);
        const cleft_status status = read_labels(f, &volume);
        if (status != CLEFT_ERROR_FORMAT && status != CLEFT_ERROR_FILE && status != CLEFT_ERROR_UNSUPPORTED)
            fail_msg("%s of %zu bytes of %zu: status %d", name, size, f->size, (int)status);
        if (!strstr(cleft_context_last_error(f->context), name))
            fail_msg("'%s' does not name %s", cleft_context_last_error(f->context), name);
        assert_null(volume);
    }
}

static void test_all_beginnings_are_refused(void** state)
{
    fixture* f = *state;
    const type* shorts = &types[3];
    for (encoding how = RAW; how <= HEX; ++how) {
        put_nrrd(f, shorts, "ushort", how, 0);
        refuse_all_beginnings(f, "a.nrrd");
    }
    for (encoding how = RAW; how <= TEXT; ++how) {
        put_meta(f, shorts, "MET_USHORT", how, 0);
        refuse_all_beginnings(f, "a.mha");
    }
    for (int text = 0; text < 2; ++text) {
        put_vtk(f, shorts, "unsigned_short", text ? TEXT : RAW, 1);
        refuse_all_beginnings(f, "a.vtk");
    }
}

/* No byte of what is compressed can be another without being noticed. */
static void test_changed_bytes_of_compressed_voxels_are_refused(void** state)
{
    fixture* f = *state;
    put_nrrd(f, &types[1], "uchar", DEFLATED, 0);
    const unsigned char* end = (const unsigned char*)strstr((const char*)f->bytes, "\n\n");
    assert_non_null(end);
    for (size_t at = (size_t)(end - f->bytes) + 2 + 10; at < f->size; ++at) { /* ten bytes are gzip's own header */
        cleft_volume* volume = NULL;
        f->bytes[at] ^= 0x10;
        store(f, "a.nrrd", f->size);
        assert_int_equal(read_labels(f, &volume), CLEFT_ERROR_FORMAT);
        f->bytes[at] ^= 0x10;
    }
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_every_nrrd),
        TEST(test_every_metaimage),
        TEST(test_every_vtk),
        TEST(test_all_beginnings_are_refused),
        TEST(test_changed_bytes_of_compressed_voxels_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
