/* Voxels without a header: types, orders of bytes, places, functions, and layouts that are refused. */
#include "folder_fixture.h"

enum { NX = 4, NY = 3, NZ = 5, VOXELS = NX * NY * NZ };

static cleft_io_raw raw_layout(cleft_type type)
{
    const cleft_io_raw raw = {.struct_size = sizeof raw, .type = type, .dims = {NX, NY, NZ}, .spacing = {0.5, 1, 2}};
    return raw;
}

static int32_t label_of(int voxel) { return voxel % 7 == 0 ? 300 : voxel / 20; }

/* Every voxel centre has its label, and the corner of the box is at the origin. */
static void check_labels(const cleft_volume* volume)
{
    for (int v = 0; v < VOXELS; ++v) {
        const double centre[3] = {0.5 * (v % NX + 0.5), v / NX % NY + 0.5, 2 * (v / (NX * NY) + 0.5)};
        int32_t label = -1;
        assert_int_equal(cleft_volume_sample(volume, centre, 1, &label), CLEFT_OK);
        assert_int_equal(label, label_of(v));
    }
}

static void test_raw_labels(void** state)
{
    fixture* f = *state;
    uint16_t native[VOXELS];
    uint8_t swapped[2 * VOXELS];
    for (int v = 0; v < VOXELS; ++v) {
        native[v] = (uint16_t)label_of(v);
        swapped[2 * v] = (uint8_t)(native[v] >> 8);
        swapped[2 * v + 1] = (uint8_t)(native[v] & 255);
    }
    for (int big_endian = 0; big_endian < 2; ++big_endian)
        for (int64_t skip = 0; skip < 10; skip += 9) {
            cleft_io_raw raw = raw_layout(CLEFT_TYPE_UINT16);
            raw.big_endian = big_endian;
            raw.skip = skip;
            const char* path = path_of(f, "a.raw");
            write_file(path, "a header.", (size_t)skip, big_endian ? (void*)swapped : (void*)native, sizeof native);
            cleft_volume* volume = NULL;
            assert_int_equal(cleft_io_read_raw(f->context, NULL, &path, 1, &raw, &volume), CLEFT_OK);
            check_labels(volume);
            cleft_volume_destroy(volume);
        }
}

/* Of every type, the least and the greatest label and two between, as numbers of 64 bits or as real numbers. */
static const struct {
    cleft_type type;
    int size;
    int is_real;
    int64_t labels[4];
} types[] = {
    {CLEFT_TYPE_UINT8, 1, 0, {0, 1, 200, 255}},
    {CLEFT_TYPE_UINT16, 2, 0, {0, 0x0102, 0x8001, 65535}},
    {CLEFT_TYPE_INT16, 2, 0, {-32768, -2, 0x0102, 32767}},
    {CLEFT_TYPE_UINT32, 4, 0, {0, 0x01020304, 65536, INT32_MAX}},
    {CLEFT_TYPE_INT32, 4, 0, {INT32_MIN, -5, 0x01020304, INT32_MAX}},
    {CLEFT_TYPE_FLOAT32, 4, 1, {-7, 0, 300, 1 << 24}},
    {CLEFT_TYPE_FLOAT64, 8, 1, {INT32_MIN, 0, 0x01020304, INT32_MAX}},
};

static void put_voxel(uint8_t* to, int64_t label, int size, int is_real, int big_endian)
{
    const float narrow = (float)label;
    const double wide = (double)label;
    uint64_t bits = (uint64_t)label;
    if (is_real && size == 8)
        memcpy(&bits, &wide, sizeof wide);
    if (is_real && size == 4) {
        uint32_t half;
        memcpy(&half, &narrow, sizeof narrow);
        bits = half;
    }
    for (int b = 0; b < size; ++b)
        to[big_endian ? size - 1 - b : b] = (uint8_t)(bits >> (8 * b));
}

static void test_every_type(void** state)
{
    fixture* f = *state;
    for (size_t t = 0; t < sizeof types / sizeof *types; ++t)
        for (int big_endian = 0; big_endian < 2; ++big_endian) {
            uint8_t voxels[8 * VOXELS];
            for (int v = 0; v < VOXELS; ++v)
                put_voxel(voxels + v * types[t].size, types[t].labels[(v + v / 5) % 4], types[t].size, types[t].is_real,
                          big_endian);
            cleft_io_raw raw = raw_layout(types[t].type);
            raw.big_endian = big_endian;
            raw.kind = CLEFT_IO_KIND_LABELS;
            memset(raw.spacing, 0, sizeof raw.spacing); /* unit cubes */
            const char* path = path_of(f, "a.raw");
            write_file(path, "", 0, voxels, (size_t)(VOXELS * types[t].size));
            cleft_volume* volume = NULL;
            if (cleft_io_read_raw(f->context, NULL, &path, 1, &raw, &volume) != CLEFT_OK)
                fail_msg("type %d: %s", types[t].type, cleft_context_last_error(f->context));
            for (int v = 0; v < VOXELS; ++v) {
                const double centre[3] = {v % NX + 0.5, v / NX % NY + 0.5, v / (NX * NY) + 0.5};
                int32_t label = -1;
                assert_int_equal(cleft_volume_sample(volume, centre, 1, &label), CLEFT_OK);
                assert_int_equal(label, types[t].labels[(v + v / 5) % 4]);
            }
            cleft_volume_destroy(volume);
        }
}

static void test_raw_indicators(void** state)
{
    fixture* f = *state;
    char paths[3][128];
    const char* list[3];
    for (int field = 0; field < 3; ++field) {
        double values[VOXELS];
        for (int v = 0; v < VOXELS; ++v)
            values[v] = v % 3 == field ? 1 : 0.25 * field;
        strcpy(paths[field], path_of(f, "0.raw"));
        paths[field][strlen(paths[field]) - 5] = (char)('0' + field);
        write_file(paths[field], "", 0, values, sizeof values);
        list[field] = paths[field];
    }
    const cleft_io_raw raw = raw_layout(CLEFT_TYPE_FLOAT64);
    cleft_volume* volume = NULL;
    assert_int_equal(cleft_io_read_raw(f->context, NULL, list, 3, &raw, &volume), CLEFT_OK);
    int64_t counts[3];
    assert_int_equal(cleft_volume_copy_voxel_counts(volume, counts, 3), CLEFT_OK);
    for (int field = 0; field < 3; ++field)
        assert_int_equal(counts[field], VOXELS / 3);
    cleft_volume_destroy(volume);
}

static void test_raw_refusals(void** state)
{
    fixture* f = *state;
    const uint8_t bytes[VOXELS + 1] = {0};
    const char* path = path_of(f, "a.raw");
    const char* two[2] = {path, path};
    const char* none = NULL;
    cleft_volume* volume = NULL;
    write_file(path, "", 0, bytes, VOXELS + 1);
    cleft_io_raw raw = raw_layout(CLEFT_TYPE_UINT8);
    assert_refused(f, cleft_io_read_raw(f->context, NULL, &path, 1, &raw, &volume), CLEFT_ERROR_FORMAT, "61 bytes");
    write_file(path, "", 0, bytes, VOXELS - 1);
    assert_refused(f, cleft_io_read_raw(f->context, NULL, &path, 1, &raw, &volume), CLEFT_ERROR_FORMAT, "59 bytes");
    write_file(path, "", 0, bytes, VOXELS);
    assert_refused(f, cleft_io_read_raw(f->context, NULL, two, 2, &raw, &volume), CLEFT_ERROR_FORMAT, "no mask");
    assert_refused(f, cleft_io_read_raw(f->context, NULL, &path, 0, &raw, &volume), CLEFT_ERROR_ARGUMENT, "one path");
    assert_refused(f, cleft_io_read_raw(f->context, NULL, &none, 1, &raw, &volume), CLEFT_ERROR_NULL, "path");
    assert_refused(f, cleft_io_read_raw(f->context, NULL, &path, 1, NULL, &volume), CLEFT_ERROR_NULL, "raw");
    raw.spacing[1] = 0;
    assert_refused(f, cleft_io_read_raw(f->context, NULL, &path, 1, &raw, &volume), CLEFT_ERROR_ARGUMENT, "spacing");
    raw = raw_layout(99);
    assert_refused(f, cleft_io_read_raw(f->context, NULL, &path, 1, &raw, &volume), CLEFT_ERROR_ARGUMENT, "type");
    raw = raw_layout(CLEFT_TYPE_UINT8);
    raw.dims[2] = INT64_MAX;
    assert_refused(f, cleft_io_read_raw(f->context, NULL, &path, 1, &raw, &volume), CLEFT_ERROR_TOO_LARGE, "voxels");
    raw.dims[2] = 0;
    assert_refused(f, cleft_io_read_raw(f->context, NULL, &path, 1, &raw, &volume), CLEFT_ERROR_ARGUMENT, "voxel");
    raw = raw_layout(CLEFT_TYPE_UINT8);
    raw.skip = -1;
    assert_refused(f, cleft_io_read_raw(f->context, NULL, &path, 1, &raw, &volume), CLEFT_ERROR_ARGUMENT, "negative");
    raw = raw_layout(CLEFT_TYPE_UINT8);
    raw.kind = CLEFT_IO_KIND_INDICATORS + 1;
    assert_refused(f, cleft_io_read_raw(f->context, NULL, &path, 1, &raw, &volume), CLEFT_ERROR_ARGUMENT, "kind 3");
    const uint32_t large[VOXELS] = {[VOXELS - 1] = 0x80000000U};
    write_file(path, "", 0, large, sizeof large);
    raw = raw_layout(CLEFT_TYPE_UINT32);
    assert_refused(f, cleft_io_read_raw(f->context, NULL, &path, 1, &raw, &volume), CLEFT_ERROR_FORMAT,
                   "label 2147483648 does not fit");
    raw = raw_layout(CLEFT_TYPE_UINT8);
    path = "/none/a.raw";
    assert_refused(f, cleft_io_read_raw(f->context, NULL, &path, 1, &raw, &volume), CLEFT_ERROR_FILE, "/none/a.raw");
    assert_null(volume);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_raw_labels),
        TEST(test_every_type),
        TEST(test_raw_indicators),
        TEST(test_raw_refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
