/* Files that are read by parts: every window is what the whole volume has there. */
#include "stored_voxels.h"

/* A window has the labels of the file. */
static void check_window(const cleft_voxels* voxels, const stored_type* type, const int64_t first[3],
                         const int64_t count[3])
{
    int32_t labels[VOXELS];
    char sentence[200] = "";
    if (voxels->read(first, count, labels, sentence, sizeof sentence, voxels->user) != 0)
        fail_msg("%s", sentence);
    for (int64_t i = 0; i < count[0] * count[1] * count[2]; ++i) {
        const int64_t x = first[0] + i % count[0];
        const int64_t y = first[1] + i / count[0] % count[1];
        const int64_t z = first[2] + i / (count[0] * count[1]);
        assert_int_equal(label_in(labels, voxels->type, i), stored_label(type, (int)(x + NX * (y + NY * z))));
    }
}

/* All windows do, also those of no voxels. */
static void check_windows(const cleft_voxels* voxels, const stored_type* type)
{
    int64_t first[3], end[3];
    for (first[0] = 0; first[0] <= NX; ++first[0])
        for (first[1] = 0; first[1] <= NY; ++first[1])
            for (first[2] = 0; first[2] <= NZ; ++first[2])
                for (end[0] = first[0]; end[0] <= NX; ++end[0])
                    for (end[1] = first[1]; end[1] <= NY; ++end[1])
                        for (end[2] = first[2]; end[2] <= NZ; ++end[2]) {
                            const int64_t count[3] = {end[0] - first[0], end[1] - first[1], end[2] - first[2]};
                            check_window(voxels, type, first, count);
                        }
}

/* The whole volume has these labels, and the same grid to the last bit. */
static void check_whole(const cleft_voxels* voxels, const cleft_volume* volume, const stored_type* type)
{
    int64_t dims[3];
    double affine[12];
    assert_int_equal(cleft_volume_dims(volume, dims), CLEFT_OK);
    assert_int_equal(cleft_volume_affine(volume, affine), CLEFT_OK);
    assert_memory_equal(dims, voxels->dims, sizeof dims);
    assert_memory_equal(affine, voxels->affine, sizeof affine);
    for (int v = 0; v < VOXELS; ++v) {
        double centre[3];
        int32_t label = 0;
        for (int row = 0; row < 3; ++row) {
            const double* a = affine + 4 * row;
            centre[row] = a[0] * (v % NX) + a[1] * (v / NX % NY) + a[2] * (v / (NX * NY)) + a[3];
        }
        assert_int_equal(cleft_volume_sample(volume, centre, 1, &label), CLEFT_OK);
        assert_int_equal(label, stored_label(type, v));
    }
}

/* The file at the path, with a layout or NULL, is of this type. */
static void check_file(fixture* f, const char* path, const cleft_io_raw* raw, const stored_type* type)
{
    const cleft_io_reading reading = {.struct_size = sizeof reading, .kind = CLEFT_IO_KIND_LABELS};
    cleft_volume* volume = NULL;
    const cleft_status status = raw ? cleft_io_read_raw(f->context, NULL, &path, 1, raw, &volume)
                                    : cleft_io_read_volume(f->context, NULL, &path, 1, &reading, &volume);
    if (status != CLEFT_OK)
        fail_msg("%s: %s", type->nrrd, cleft_context_last_error(f->context));
    cleft_voxels voxels = opened(f, path, raw);
    assert_int_equal(voxels.type, type->labels);
    check_whole(&voxels, volume, type);
    check_windows(&voxels, type);
    cleft_io_voxels_close(&voxels);
    assert_null(voxels.user);
    cleft_volume_destroy(volume);
}

static void test_raw(void** state)
{
    fixture* f = *state;
    static const struct {
        int stored;
        cleft_type type;
    } types[] = {{0, CLEFT_TYPE_UINT8},
                 {2, CLEFT_TYPE_UINT16},
                 {3, CLEFT_TYPE_INT16},
                 {4, CLEFT_TYPE_UINT32},
                 {5, CLEFT_TYPE_INT32}};
    for (int t = 0; t < 5; ++t)
        for (int variant = 0; variant < 4; ++variant) {
            uint8_t bytes[8 * VOXELS];
            const stored_type* type = &stored_types[types[t].stored];
            const cleft_io_raw raw = {.struct_size = sizeof raw,
                                      .type = types[t].type,
                                      .big_endian = variant & 1,
                                      .kind = CLEFT_IO_KIND_LABELS,
                                      .skip = variant & 2 ? 9 : 0,
                                      .dims = {NX, NY, NZ},
                                      .spacing = {0.1, 0.7, 2}};
            const char* path = path_of(f, "a.raw");
            write_file(path, "a header.", (size_t)raw.skip, bytes, put_voxels(bytes, type, variant & 1));
            check_file(f, path, &raw, type);
        }
}

static void test_nrrd(void** state)
{
    fixture* f = *state;
    for (int t = 0; t < STORED_TYPES; ++t)
        for (int big = 0; big < 2; ++big) {
            const stored_type* type = &stored_types[t];
            check_file(f, written(f, "a.nrrd", nrrd_header(type, big, "\n"), NULL, type, big), NULL, type);
            check_file(f, written(f, "a.nhdr", nrrd_header(type, big, "data file: a.raw\n"), "", type, big), NULL,
                       type);
        }
    /* Voxels behind lines and bytes, and at the end of a file. */
    const stored_type* type = &stored_types[3];
    const char* skip = "data file: a.raw\nline skip: 2\nbyte skip: 5\n";
    check_file(f, written(f, "a.nhdr", nrrd_header(type, 1, skip), "one\ntwo\n12345", type, 1), NULL, type);
    const char* last = "data file: a.raw\nbyte skip: -1\n";
    check_file(f, written(f, "a.nhdr", nrrd_header(type, 1, last), "whatever", type, 1), NULL, type);
    const char* segments = "Segment0_ID:=a\nSegment0_LabelValue:=258\n\n";
    check_file(f, written(f, "a.seg.nrrd", nrrd_header(type, 0, segments), NULL, type, 0), NULL, type);
}

static void test_metaimage(void** state)
{
    fixture* f = *state;
    for (int t = 0; t < STORED_TYPES; ++t)
        for (int big = 0; big < 2; ++big) {
            const stored_type* type = &stored_types[t];
            const char* header = meta_header(type, big, "ElementDataFile = LOCAL\n");
            check_file(f, written(f, "a.mha", header, NULL, type, big), NULL, type);
            header = meta_header(type, big, "ElementDataFile = a.raw\n");
            check_file(f, written(f, "a.mhd", header, "", type, big), NULL, type);
        }
    const stored_type* type = &stored_types[2];
    const char* header = meta_header(type, 1, "HeaderSize = 5\nElementDataFile = a.raw\n");
    check_file(f, written(f, "a.mhd", header, "12345", type, 1), NULL, type);
    header = meta_header(type, 1, "HeaderSize = -1\nElementDataFile = a.raw\n");
    check_file(f, written(f, "a.mhd", header, "whatever", type, 1), NULL, type);
}

static void test_nifti(void** state)
{
    fixture* f = *state;
    for (int t = 0; t < STORED_TYPES; ++t)
        for (int big = 0; big < 2; ++big) {
            uint8_t header[NIFTI_VOXELS], bytes[8 * VOXELS];
            const stored_type* type = &stored_types[t];
            const size_t size = put_voxels(bytes, type, big);
            put_nifti_header(header, type, big, 1, 0);
            write_file(path_of(f, "a.nii"), header, sizeof header, bytes, size);
            check_file(f, f->path, NULL, type);
            put_nifti_header(header, type, big, 0, 1);
            write_file(path_of(f, "b.img"), bytes, size, "", 0);
            write_file(path_of(f, "b.hdr"), header, NIFTI_HEADER, "", 0);
            check_file(f, f->path, NULL, type);
            check_file(f, path_of(f, "b.img"), NULL, type);
        }
}

static void test_vtk(void** state)
{
    fixture* f = *state;
    static const char* const names[] = {"unsigned_char", "char", "unsigned_short", "short",
                                        "unsigned_int",  "int",  "unsigned_long",  "long"};
    for (int t = 0; t < STORED_TYPES; ++t)
        for (int on_cells = 0; on_cells < 2; ++on_cells) {
            char text[500];
            uint8_t bytes[9 * VOXELS + 100];
            const stored_type* type = &stored_types[t];
            snprintf(text, sizeof text,
                     "# vtk DataFile Version 3.0\ntitle\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS %d %d %d\n"
                     "ORIGIN 1.1 2.3 -0.7\nSPACING 0.1 0.3 0.7\n%s_DATA %d\nSCALARS labels %s 1\n"
                     "LOOKUP_TABLE default\n",
                     NX + on_cells, NY + on_cells, NZ + on_cells, on_cells ? "CELL" : "POINT", VOXELS, names[t]);
            /* Another array of the same size stands behind the voxels. */
            size_t size = put_voxels(bytes, type, 1);
            size +=
                (size_t)snprintf((char*)bytes + size, 60, "\nSCALARS other unsigned_char 1\nLOOKUP_TABLE default\n");
            memset(bytes + size, 7, VOXELS);
            write_file(path_of(f, "a.vtk"), text, strlen(text), bytes, size + VOXELS);
            check_file(f, f->path, NULL, type);
        }
}

/* A file of which 32 bits do not count the voxels; it has holes, which need no disk. */
static void test_large_file(void** state)
{
    fixture* f = *state;
    const cleft_io_raw raw = {.struct_size = sizeof raw, .type = CLEFT_TYPE_UINT16, .dims = {1 << 16, 1 << 10, 65}};
    const char* path = path_of(f, "a.raw");
    const uint16_t last[2] = {11, 12};
    const int64_t end = 2 * raw.dims[0] * raw.dims[1] * raw.dims[2];
    FILE* file = fopen(path, "wb");
    assert_int_equal(fseeko(file, end - (int64_t)sizeof last, SEEK_SET), 0);
    assert_int_equal(fwrite(last, sizeof last, 1, file), 1);
    assert_int_equal(fclose(file), 0);
    cleft_voxels voxels = opened(f, path, &raw);
    const int64_t first[3] = {raw.dims[0] - 2, raw.dims[1] - 2, 64}, count[3] = {2, 2, 1};
    uint16_t labels[4];
    assert_int_equal(voxels.read(first, count, labels, NULL, 0, voxels.user), 0);
    assert_memory_equal(labels, ((uint16_t[4]){0, 0, 11, 12}), sizeof labels);
    cleft_io_voxels_close(&voxels);
}

typedef struct logged {
    cleft_voxels* voxels;
    int reads;
    char sentence[300];
} logged;

/* Called while the context is busy. */
static void read_while_busy(int32_t level, const char* sentence, void* user)
{
    (void)level;
    logged* seen = user;
    const int64_t first[3] = {0, 0, 0}, count[3] = {NX, NY, NZ};
    uint8_t labels[VOXELS];
    seen->reads += seen->voxels->read(first, count, labels, NULL, 0, seen->voxels->user) == 0;
    snprintf(seen->sentence, sizeof seen->sentence, "%s", sentence);
}

/* A byte too many is told, as it is of a whole volume; and the callback reads another file meanwhile. */
static void test_warnings_and_busy_contexts(void** state)
{
    fixture* f = *state;
    const stored_type* type = &stored_types[0];
    cleft_voxels voxels = opened(f, written(f, "a.nrrd", nrrd_header(type, 0, "\n"), NULL, type, 0), NULL);
    logged seen = {.voxels = &voxels};
    assert_int_equal(cleft_context_set_log(f->context, read_while_busy, &seen), CLEFT_OK);
    uint8_t bytes[8 * VOXELS];
    const char* header = nrrd_header(type, 0, "\n");
    write_file(path_of(f, "b.nrrd"), header, strlen(header), bytes, put_voxels(bytes, type, 0) + 1);
    cleft_voxels other = opened(f, f->path, NULL);
    assert_int_equal(seen.reads, 1);
    assert_non_null(strstr(seen.sentence, "b.nrrd': 1 byte behind its voxels is not read"));
    cleft_io_voxels_close(&other);
    cleft_io_voxels_close(&voxels);
    write_file(path_of(f, "b.nrrd"), header, strlen(header), bytes, 2 * VOXELS);
    refuse_open(f, f->path, NULL, CLEFT_ERROR_FORMAT, "twice as many");
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_raw),
        TEST(test_nrrd),
        TEST(test_metaimage),
        TEST(test_nifti),
        TEST(test_vtk),
        TEST(test_large_file),
        TEST(test_warnings_and_busy_contexts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
