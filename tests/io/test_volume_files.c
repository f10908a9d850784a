/* Sizing fields and fields in files. What other formats of volumes hold is tested by check_volumes.py. */
#include "folder_fixture.h"

#include <math.h>
#include <signal.h>
#include <sys/resource.h>

enum { NX = 4, NY = 3, NZ = 5, VOXELS = NX * NY * NZ };

/* A grid that is turned, flipped and off the origin; sheared if asked for. */
static void make_affine(int sheared, double affine[12])
{
    const double turned[12] = {0, -0.8 * 1.5, 0.6 * 2, 10, 0, 0.6 * 1.5, 0.8 * 2, -20, -0.5, 0, 0, 30};
    memcpy(affine, turned, sizeof turned);
    if (sheared)
        affine[9] = 0.3;
}

static cleft_volume* make_volume(fixture* f, const double affine[12])
{
    static const int64_t dims[3] = {NX, NY, NZ};
    uint8_t voxels[VOXELS];
    cleft_volume* volume = NULL;
    for (int v = 0; v < VOXELS; ++v)
        voxels[v] = v % NX < 2;
    assert_int_equal(cleft_volume_create_labels(f->context, CLEFT_TYPE_UINT8, voxels, dims, affine, NULL, &volume),
                     CLEFT_OK);
    return volume;
}

static cleft_sizing* make_sizing(fixture* f, const cleft_volume* volume)
{
    double values[VOXELS];
    cleft_sizing* sizing = NULL;
    for (int v = 0; v < VOXELS; ++v)
        values[v] = 1 + v / 7.0;
    assert_int_equal(cleft_sizing_create_values(f->context, volume, CLEFT_TYPE_FLOAT64, values, 0, NULL, &sizing),
                     CLEFT_OK);
    return sizing;
}

static void test_sizing_comes_back(void** state)
{
    static const char* const names[] = {"a.nrrd", "a.nii", "a.nii.gz", "a.mha"};
    fixture* f = *state;
    double affine[12];
    make_affine(0, affine);
    cleft_volume* volume = make_volume(f, affine);
    cleft_sizing* sizing = make_sizing(f, volume);
    assert_non_null(sizing);
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i)
        for (cleft_io_world world = CLEFT_IO_WORLD_LPS; world <= CLEFT_IO_WORLD_RAS; ++world) {
            const cleft_io_reading reading = {.struct_size = sizeof reading, .world = world};
            int64_t dims[3];
            double read_affine[12];
            double* values = NULL;
            cleft_sizing* read = NULL;
            assert_int_equal(cleft_io_write_sizing(f->context, sizing, path_of(f, names[i]), world), CLEFT_OK);
            assert_int_equal(cleft_io_read_field(f->context, f->path, &reading, dims, read_affine, &values), CLEFT_OK);
            assert_int_equal(dims[0], NX);
            assert_int_equal(dims[1], NY);
            assert_int_equal(dims[2], NZ);
            for (int a = 0; a < 12; ++a)
                assert_true(fabs(read_affine[a] - affine[a]) < 1e-5);
            for (int v = 0; v < VOXELS; ++v)
                assert_true(values[v] == (double)cleft_sizing_values(sizing)[v]);
            cleft_io_free(values);
            assert_int_equal(cleft_io_read_sizing(f->context, volume, f->path, &reading, 0, NULL, &read), CLEFT_OK);
            assert_memory_equal(cleft_sizing_values(read), cleft_sizing_values(sizing), VOXELS * sizeof(float));
            cleft_sizing_destroy(read);
        }
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
}

/* A NIfTI file has the place of its voxels twice; here the second one, the qform, is read. Each of these turns makes
 * another component of the quaternion the largest. */
static void test_qform_of_sizing(void** state)
{
    static const double turns[][9] = {{1, 0, 0, 0, 1, 0, 0, 0, 1},         {1, 0, 0, 0, -1, 0, 0, 0, -1},
                                      {-1, 0, 0, 0, 1, 0, 0, 0, -1},       {-1, 0, 0, 0, -1, 0, 0, 0, 1},
                                      {0, 1, 0, 0, 0, 1, 1, 0, 0},         {0, -0.8, 0.6, 0, 0.6, 0.8, -1, 0, 0},
                                      {0.8, 0.6, 0, 0.6, -0.8, 0, 0, 0, 1}};
    fixture* f = *state;
    for (size_t t = 0; t < sizeof turns / sizeof *turns; ++t) {
        double affine[12] = {0};
        for (int row = 0; row < 3; ++row) {
            for (int axis = 0; axis < 3; ++axis)
                affine[4 * row + axis] = turns[t][3 * row + axis] * (axis + 1);
            affine[4 * row + 3] = 10 * row - 5;
        }
        cleft_volume* volume = make_volume(f, affine);
        cleft_sizing* sizing = make_sizing(f, volume);
        assert_int_equal(cleft_io_write_sizing(f->context, sizing, path_of(f, "a.nii"), 0), CLEFT_OK);
        FILE* file = fopen(f->path, "r+b");
        assert_int_equal(fseek(file, 254, SEEK_SET), 0); /* sform_code */
        fwrite("\0\0", 1, 2, file);
        fclose(file);
        double read_affine[12];
        double* values = NULL;
        assert_int_equal(cleft_io_read_field(f->context, f->path, NULL, NULL, read_affine, &values), CLEFT_OK);
        for (int a = 0; a < 12; ++a)
            assert_true(fabs(read_affine[a] - affine[a]) < 2e-3);
        cleft_io_free(values);
        cleft_sizing_destroy(sizing);
        cleft_volume_destroy(volume);
    }
}

static void test_sizing_of_sheared_grids(void** state)
{
    fixture* f = *state;
    double affine[12];
    make_affine(1, affine);
    cleft_volume* volume = make_volume(f, affine);
    cleft_sizing* sizing = make_sizing(f, volume);
    cleft_sizing* read = NULL;
    const char* const names[] = {"a.nrrd", "a.nii"};
    for (int i = 0; i < 2; ++i) {
        assert_int_equal(cleft_io_write_sizing(f->context, sizing, path_of(f, names[i]), 0), CLEFT_OK);
        assert_int_equal(cleft_io_read_sizing(f->context, volume, f->path, NULL, 0, NULL, &read), CLEFT_OK);
        cleft_sizing_destroy(read);
    }
    assert_refused(f, cleft_io_write_sizing(f->context, sizing, path_of(f, "a.mha"), 0), CLEFT_ERROR_UNSUPPORTED,
                   "sheared");
    assert_refused(f, cleft_io_write_sizing(f->context, sizing, path_of(f, "a.vtk"), 0), CLEFT_ERROR_UNSUPPORTED,
                   "sheared");
    assert_refused(f, cleft_io_write_sizing(f->context, sizing, path_of(f, "a.png"), 0), CLEFT_ERROR_ARGUMENT, ".nrrd");
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
}

/* Legacy VTK has no directions: the grid is straight. */
static void test_sizing_comes_back_from_vtk(void** state)
{
    fixture* f = *state;
    const double affine[12] = {0.1, 0, 0, 10, 0, 1.5, 0, -20, 0, 0, 2, 30};
    cleft_volume* volume = make_volume(f, affine);
    cleft_sizing* sizing = make_sizing(f, volume);
    cleft_sizing* read = NULL;
    int64_t dims[3];
    double read_affine[12];
    double* values = NULL;
    assert_int_equal(cleft_io_write_sizing(f->context, sizing, path_of(f, "a.vtk"), 0), CLEFT_OK);
    assert_int_equal(cleft_io_read_field(f->context, f->path, NULL, dims, read_affine, &values), CLEFT_OK);
    for (int a = 0; a < 12; ++a)
        assert_true(read_affine[a] == affine[a]); /* the shortest decimals that give the same number back */
    for (int v = 0; v < VOXELS; ++v)
        assert_true(values[v] == (double)cleft_sizing_values(sizing)[v]);
    cleft_io_free(values);
    assert_int_equal(cleft_io_read_sizing(f->context, volume, f->path, NULL, 0, NULL, &read), CLEFT_OK);
    cleft_sizing_destroy(read);
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
}

static void test_sizing_of_another_grid_is_refused(void** state)
{
    fixture* f = *state;
    double affine[12];
    make_affine(0, affine);
    cleft_volume* volume = make_volume(f, affine);
    cleft_sizing* sizing = make_sizing(f, volume);
    affine[3] += 0.1;
    cleft_volume* shifted = make_volume(f, affine);
    cleft_sizing* read = NULL;
    assert_int_equal(cleft_io_write_sizing(f->context, sizing, path_of(f, "a.nrrd"), 0), CLEFT_OK);
    assert_refused(f, cleft_io_read_sizing(f->context, shifted, f->path, NULL, 0, NULL, &read), CLEFT_ERROR_ARGUMENT,
                   "places");
    const cleft_io_reading ras = {.struct_size = sizeof ras, .world = CLEFT_IO_WORLD_RAS};
    assert_refused(f, cleft_io_read_sizing(f->context, volume, f->path, &ras, 0, NULL, &read), CLEFT_ERROR_ARGUMENT,
                   "places");
    assert_null(read);
    cleft_volume_destroy(shifted);
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
}

/* Geometry that is read with a scale of a thousandth, with another spacing along y if one is given. */
static void check_scaled(fixture* f, const double affine[12], double spacing)
{
    cleft_io_reading reading = {.struct_size = sizeof reading, .scale = 1e-3, .spacing = {0, spacing, 0}};
    double read_affine[12];
    double* values = NULL;
    assert_int_equal(cleft_io_read_field(f->context, f->path, &reading, NULL, read_affine, &values), CLEFT_OK);
    const double length = sqrt(affine[1] * affine[1] + affine[5] * affine[5] + affine[9] * affine[9]);
    for (int a = 0; a < 12; ++a)
        assert_true(fabs(read_affine[a] - affine[a] * (a % 4 == 1 && spacing > 0 ? spacing / length : 1e-3)) < 1e-9);
    assert_true(values[0] == 1);
    cleft_io_free(values);
}

static void test_scale_takes_origin_and_spacing(void** state)
{
    fixture* f = *state;
    double affine[12];
    double scaled[12];
    make_affine(0, affine);
    cleft_volume* volume = make_volume(f, affine);
    cleft_sizing* sizing = make_sizing(f, volume);
    assert_int_equal(cleft_io_write_sizing(f->context, sizing, path_of(f, "a.nrrd"), 0), CLEFT_OK);
    check_scaled(f, affine, 0);
    check_scaled(f, affine, 0.25);

    for (int a = 0; a < 12; ++a)
        scaled[a] = 1e-3 * affine[a];
    cleft_volume* small = make_volume(f, scaled);
    cleft_sizing* read = NULL;
    cleft_io_reading reading = {.struct_size = sizeof reading, .scale = 1e-3};
    assert_int_equal(cleft_io_read_sizing(f->context, small, f->path, &reading, 0, NULL, &read), CLEFT_OK);
    for (int v = 0; v < VOXELS; ++v)
        assert_true(fabs(cleft_sizing_values(read)[v] - 1e-3 * cleft_sizing_values(sizing)[v]) < 1e-8);
    cleft_sizing_destroy(read);

    static const double refused[] = {-1, NAN, INFINITY};
    for (size_t i = 0; i < sizeof refused / sizeof *refused; ++i) {
        reading.scale = refused[i];
        assert_refused(f, cleft_io_read_sizing(f->context, small, f->path, &reading, 0, NULL, &read),
                       CLEFT_ERROR_ARGUMENT, "scale");
    }
    cleft_volume_destroy(small);
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
}

/* Too small a struct_size is refused; a reader of an older size, without the scale, is not, and a newer one is unless
 * it asks for what this version does not know. */
static void test_struct_sizes(void** state)
{
    static const uint32_t bad[] = {0, 1, 4, 12, offsetof(cleft_io_reading, scale) - 1, 0x55555555, UINT32_MAX};
    fixture* f = *state;
    struct {
        cleft_io_reading known;
        int64_t later;
    } newer = {{.struct_size = sizeof newer, .world = CLEFT_IO_WORLD_RAS}, 0};
    cleft_io_reading reading = {.world = CLEFT_IO_WORLD_RAS, .scale = -1};
    cleft_io_raw raw = {.type = CLEFT_TYPE_UINT8, .dims = {NX, NY, NZ}};
    cleft_io_format_description row = {0};
    double affine[12], read_affine[12];
    double* values = NULL;
    make_affine(0, affine);
    cleft_volume* volume = make_volume(f, affine);
    cleft_sizing* sizing = make_sizing(f, volume);
    const char* path = path_of(f, "a.nrrd");
    assert_int_equal(cleft_io_write_sizing(f->context, sizing, path, CLEFT_IO_WORLD_LPS), CLEFT_OK);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        reading.struct_size = bad[i];
        assert_refused(f, cleft_io_read_field(f->context, path, &reading, NULL, NULL, &values), CLEFT_ERROR_ARGUMENT,
                       "struct_size of the cleft_io_reading");
        assert_null(values);
    }
    reading.struct_size = offsetof(cleft_io_reading, scale);
    assert_int_equal(cleft_io_read_field(f->context, path, &reading, NULL, read_affine, &values), CLEFT_OK);
    assert_true(fabs(read_affine[3] + affine[3]) < 1e-9 && fabs(read_affine[0] + affine[0]) < 1e-9);
    cleft_io_free(values);
    assert_int_equal(cleft_io_read_field(f->context, path, &newer.known, NULL, read_affine, &values), CLEFT_OK);
    assert_true(fabs(read_affine[3] + affine[3]) < 1e-9);
    cleft_io_free(values);
    newer.later = 1;
    assert_refused(f, cleft_io_read_field(f->context, path, &newer.known, NULL, NULL, &values), CLEFT_ERROR_ARGUMENT,
                   "does not know");
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
    volume = NULL;
    for (raw.struct_size = 0; raw.struct_size < sizeof raw; raw.struct_size += 8)
        assert_refused(f, cleft_io_read_raw(f->context, NULL, &path, 1, &raw, &volume), CLEFT_ERROR_ARGUMENT,
                       "struct_size of the cleft_io_raw");
    for (row.struct_size = 0; row.struct_size < sizeof row; row.struct_size += 8)
        assert_int_equal(cleft_io_format_info(0, &row), CLEFT_ERROR_ARGUMENT);
}

static void test_full_disk_keeps_the_old_field(void** state)
{
    static const char* const names[] = {"a.nrrd", "a.nii", "a.nii.gz", "a.mha"};
    fixture* f = *state;
    double affine[12];
    make_affine(0, affine);
    cleft_volume* volume = make_volume(f, affine);
    cleft_sizing* sizing = make_sizing(f, volume);
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        struct rlimit limit;
        char kept[4] = "";
        write_file(path_of(f, names[i]), "", 0, "old", 3);
        signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &limit);
        const struct rlimit small = {100, limit.rlim_max};
        assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
        const cleft_status status = cleft_io_write_sizing(f->context, sizing, f->path, 0);
        assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
        assert_refused(f, status, CLEFT_ERROR_FILE, names[i]);
        FILE* file = fopen(f->path, "rb");
        assert_non_null(file);
        assert_int_equal(fread(kept, 1, 4, file), 3);
        assert_string_equal(kept, "old");
        fclose(file);
    }
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_sizing_comes_back),
        TEST(test_qform_of_sizing),
        TEST(test_sizing_of_sheared_grids),
        TEST(test_sizing_comes_back_from_vtk),
        TEST(test_sizing_of_another_grid_is_refused),
        TEST(test_scale_takes_origin_and_spacing),
        TEST(test_struct_sizes),
        TEST(test_full_disk_keeps_the_old_field),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
