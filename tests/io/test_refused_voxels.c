/* Files that cannot be read by parts, voxels that are not there, and arguments that make no sense. */
#include "stored_voxels.h"

#include <zlib.h>

/* A file that is cut anywhere is refused at once, and what is cut later when it is read. */
static void test_cut_files(void** state)
{
    fixture* f = *state;
    const stored_type* type = &stored_types[3];
    const char* header = nrrd_header(type, 0, "\n");
    const long begin = (long)strlen(header), end = begin + VOXELS * type->size;
    const char* path = written(f, "a.nrrd", header, NULL, type, 0);
    for (long size = end - 1; size >= 0; --size) {
        cleft_voxels voxels = {.struct_size = sizeof voxels};
        assert_int_equal(truncate(path, size), 0);
        assert_int_not_equal(cleft_io_voxels_open(f->context, path, NULL, &voxels), CLEFT_OK);
        assert_non_null(strstr(cleft_context_last_error(f->context), "a.nrrd'"));
    }
    written(f, "a.nrrd", header, NULL, type, 0);
    assert_int_equal(truncate(path, end - 1), 0);
    refuse_open(f, path, NULL, CLEFT_ERROR_FORMAT, "but its 120 bytes of voxels begin at byte");

    written(f, "a.nrrd", header, NULL, type, 0);
    cleft_voxels voxels = opened(f, path, NULL);
    assert_int_equal(truncate(path, end - 1), 0);
    const int64_t first[3] = {0, 0, NZ - 1}, count[3] = {NX, NY, 1};
    int16_t labels[VOXELS];
    char sentence[200];
    assert_int_equal(voxels.read(first, count, labels, sentence, sizeof sentence, voxels.user), CLEFT_ERROR_FORMAT);
    assert_non_null(strstr(sentence, "a.nrrd': its voxels from byte "));
    assert_non_null(strstr(sentence, "1 byte is missing"));
    char little[8] = "1234567";
    assert_int_equal(voxels.read(first, count, labels, little, 5, voxels.user), CLEFT_ERROR_FORMAT);
    assert_memory_equal(little, sentence, 4);
    assert_memory_equal(little + 4,
                        "\0"
                        "67",
                        3);
    assert_int_equal(voxels.read(first, count, labels, NULL, 0, voxels.user), CLEFT_ERROR_FORMAT);
    cleft_io_voxels_close(&voxels);
}

static void test_windows_outside(void** state)
{
    fixture* f = *state;
    const stored_type* type = &stored_types[0];
    cleft_voxels voxels = opened(f, written(f, "a.nrrd", nrrd_header(type, 0, "\n"), NULL, type, 0), NULL);
    uint8_t labels[VOXELS];
    char sentence[200];
    for (int axis = 0; axis < 3; ++axis)
        for (int wrong = 0; wrong < 4; ++wrong) {
            int64_t first[3] = {0, 0, 0}, count[3] = {1, 1, 1};
            first[axis] = wrong == 0 ? -1 : wrong == 1 ? INT64_MAX : wrong == 2 ? voxels.dims[axis] : 1;
            count[axis] = wrong == 3 ? INT64_MAX : 1;
            assert_int_equal(voxels.read(first, count, labels, sentence, sizeof sentence, voxels.user),
                             CLEFT_ERROR_ARGUMENT);
            assert_non_null(strstr(sentence, axis == 0 ? "1st axis" : axis == 1 ? "2nd axis" : "3rd axis"));
        }
    const int64_t one[3] = {1, 1, 1};
    assert_int_equal(voxels.read(NULL, one, labels, sentence, sizeof sentence, voxels.user), CLEFT_ERROR_NULL);
    assert_int_equal(voxels.read(one, one, NULL, sentence, sizeof sentence, voxels.user), CLEFT_ERROR_NULL);
    cleft_io_voxels_close(&voxels);
}

/* What lies in no place of its own is refused, with a way out. */
static void test_refused_files(void** state)
{
    fixture* f = *state;
    const stored_type* type = &stored_types[0];
    const cleft_status unsupported = CLEFT_ERROR_UNSUPPORTED;
    uint8_t header[NIFTI_VOXELS], bytes[8 * VOXELS];
    const size_t size = put_voxels(bytes, type, 0);
    put_nifti_header(header, type, 0, 1, 2);
    write_file(path_of(f, "a.nii"), header, sizeof header, bytes, size);
    refuse_open(f, f->path, NULL, unsupported, "scaled");
    put_nifti_header(header, type, 0, 1, 0);
    gzFile packed = gzopen(path_of(f, "a.nii.gz"), "wb");
    assert_int_equal(gzwrite(packed, header, sizeof header), sizeof header);
    assert_int_equal(gzwrite(packed, bytes, (unsigned)size), size);
    assert_int_equal(gzclose(packed), Z_OK);
    refuse_open(f, f->path, NULL, unsupported, "a.nii.gz': its voxels are compressed");
    refuse_open(f, f->path, NULL, unsupported, "SimpleITK.ReadImage('a.nii.gz'), 'a-raw.mha')");

    const char* text = "CompressedData = True\nElementDataFile = LOCAL\n";
    refuse_open(f, written(f, "a.mha", meta_header(type, 0, text), NULL, type, 0), NULL, unsupported, "compressed");
    text = "BinaryData = False\nElementDataFile = LOCAL\n";
    refuse_open(f, written(f, "a.mha", meta_header(type, 0, text), NULL, type, 0), NULL, unsupported, "text");
    text = "ElementDataFile = LIST\na.raw\nb.raw\nc.raw\n";
    refuse_open(f, written(f, "a.mhd", meta_header(type, 0, text), "", type, 0), NULL, unsupported, "in 3 files");
    text = "data file: LIST\na.raw\nb.raw\nc.raw\n";
    refuse_open(f, written(f, "a.nhdr", nrrd_header(type, 0, text), "", type, 0), NULL, unsupported, "in 3 files");
    stored_type real = *type;
    real.nrrd = "float";
    refuse_open(f, written(f, "a.nrrd", nrrd_header(&real, 0, "\n"), NULL, type, 0), NULL, unsupported,
                "floating-point");
    text = "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 5 4 1 3\nkinds: space space space list\nencoding: raw\n\n";
    refuse_open(f, written(f, "a.nrrd", text, NULL, type, 0), NULL, unsupported, "3 volumes");
    text = "Segmentation_SourceRepresentation:=Fractional labelmap\nSegment0_ID:=a\n\n";
    refuse_open(f, written(f, "a.nrrd", nrrd_header(type, 0, text), NULL, type, 0), NULL, unsupported, "fractions");
    write_file(path_of(f, "a.tif"), "II*\0\10\0\0\0", 8, bytes, size);
    refuse_open(f, f->path, NULL, unsupported, "it is TIFF, which cannot be read by parts");
    write_file(path_of(f, "a.npy"), "\x93NUMPY", 6, bytes, size);
    refuse_open(f, f->path, NULL, unsupported, "NumPy");
    refuse_open(f, path_of(f, "none.nrrd"), NULL, CLEFT_ERROR_FILE, "none.nrrd': there is no such file");
    refuse_open(f, f->folder, NULL, CLEFT_ERROR_FILE, "folder");
}

static void test_refused_arguments(void** state)
{
    fixture* f = *state;
    cleft_voxels voxels = {.struct_size = sizeof voxels};
    cleft_io_raw raw = {.struct_size = sizeof raw, .type = CLEFT_TYPE_UINT8, .dims = {NX, NY, NZ}};
    uint8_t bytes[8 * VOXELS];
    const char* path = path_of(f, "a.raw");
    write_file(path, "", 0, bytes, put_voxels(bytes, &stored_types[0], 0));
    assert_refused(f, cleft_io_voxels_open(f->context, NULL, &raw, &voxels), CLEFT_ERROR_NULL, "path");
    assert_refused(f, cleft_io_voxels_open(f->context, path, &raw, NULL), CLEFT_ERROR_NULL, "out");
    raw.kind = CLEFT_IO_KIND_INDICATORS;
    refuse_open(f, path, &raw, CLEFT_ERROR_ARGUMENT, "indicators");
    raw.kind = CLEFT_IO_KIND_AUTO;
    raw.dims[2] = NZ - 1;
    refuse_open(f, path, &raw, CLEFT_ERROR_FORMAT, "60 bytes");
    raw.dims[2] = NZ + 1;
    refuse_open(f, path, &raw, CLEFT_ERROR_FORMAT, "60 bytes");
    raw.dims[2] = INT64_MAX;
    refuse_open(f, path, &raw, CLEFT_ERROR_TOO_LARGE, "voxels");
    raw.dims[2] = NZ;
    raw.type = CLEFT_TYPE_FLOAT32;
    raw.dims[0] = 1, raw.dims[1] = 5;
    refuse_open(f, path, &raw, CLEFT_ERROR_UNSUPPORTED, "floating-point");
    voxels.struct_size = 4;
    assert_refused(f, cleft_io_voxels_open(f->context, path, &raw, &voxels), CLEFT_ERROR_ARGUMENT, "cleft_voxels");
    /* A label that the core does not know. */
    put_whole(bytes, 0x80000000, 4, 0);
    write_file(path, bytes, 4, "", 0);
    raw = (cleft_io_raw){.struct_size = sizeof raw, .type = CLEFT_TYPE_UINT32, .dims = {1, 1, 1}};
    voxels = opened(f, path, &raw);
    const int64_t first[3] = {0, 0, 0}, count[3] = {1, 1, 1};
    char sentence[200];
    int32_t label;
    assert_int_equal(voxels.read(first, count, &label, sentence, sizeof sentence, voxels.user), CLEFT_ERROR_FORMAT);
    assert_non_null(strstr(sentence, "a.raw': label 2147483648 does not fit"));
    cleft_io_voxels_close(&voxels);
    cleft_io_voxels_close(&voxels);
    cleft_io_voxels_close(NULL);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_cut_files),
        TEST(test_windows_outside),
        TEST(test_refused_files),
        TEST(test_refused_arguments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
