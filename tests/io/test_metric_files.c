/* Metrics in files: written and read again, and in the orders and frames that files may have. */
#include "folder_fixture.h"

#include <math.h>

enum { NX = 4, NY = 3, NZ = 2, VOXELS = NX * NY * NZ };

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

static void tensor_of(int v, double m[6])
{
    const double six[6] = {1 + 0.01 * v, 0.1, -0.2, 0.7, 0.05, 0.5};
    memcpy(m, six, sizeof six);
}

static cleft_sizing* make_metric(fixture* f, const cleft_volume* volume)
{
    double tensors[6 * VOXELS];
    cleft_sizing* sizing = NULL;
    for (int v = 0; v < VOXELS; ++v)
        tensor_of(v, tensors + 6 * v);
    assert_int_equal(cleft_sizing_create_metric(f->context, volume, CLEFT_TYPE_FLOAT64, tensors, 0, NULL, &sizing),
                     CLEFT_OK);
    return sizing;
}

static void assert_metric(const cleft_sizing* sizing, double factor)
{
    float back[6 * VOXELS];
    assert_int_equal(cleft_sizing_copy_metric(sizing, back, 6 * VOXELS), CLEFT_OK);
    for (int v = 0; v < VOXELS; ++v) {
        double m[6];
        tensor_of(v, m);
        for (int c = 0; c < 6; ++c)
            assert_true(fabs(back[6 * v + c] - factor * m[c]) < 1e-5 * factor);
    }
}

static cleft_status read_metric(fixture* f, const cleft_volume* volume, const cleft_io_reading* reading,
                                cleft_io_tensor_order order, cleft_sizing** out)
{
    return cleft_io_read_metric(f->context, volume, f->path, reading, order, 0, NULL, out);
}

/* Turned, flipped and off the origin, in either world; the grid of the file serves without a volume. */
static void test_metrics_come_back(void** state)
{
    static const double turned[12] = {0, -0.8 * 1.5, 0.6 * 2, 10, 0, 0.6 * 1.5, 0.8 * 2, -20, -0.5, 0, 0, 30};
    static const double straight[12] = {0.5, 0, 0, 1, 0, 2, 0, -3, 0, 0, 1.5, 4};
    fixture* f = *state;
    for (int format = 0; format < 2; ++format)
        for (cleft_io_world world = CLEFT_IO_WORLD_LPS; world <= CLEFT_IO_WORLD_RAS; ++world) {
            const cleft_io_reading reading = {.struct_size = sizeof reading, .world = world};
            double affine[12];
            memcpy(affine, format == 0 ? turned : straight, sizeof affine);
            for (int i = 0; i < 8; ++i)
                affine[i] *= format == 1 && world == CLEFT_IO_WORLD_RAS ? -1 : 1;
            cleft_volume* volume = make_volume(f, affine);
            cleft_sizing* sizing = make_metric(f, volume);
            cleft_sizing* read = NULL;
            double read_affine[12];
            const char* path = path_of(f, format == 0 ? "m.nrrd" : "m.vtk");
            assert_int_equal(cleft_io_write_sizing(f->context, sizing, path, world), CLEFT_OK);
            assert_int_equal(read_metric(f, volume, &reading, CLEFT_IO_ORDER_FILE, &read), CLEFT_OK);
            assert_metric(read, 1);
            cleft_sizing_destroy(read);
            assert_int_equal(read_metric(f, NULL, &reading, CLEFT_IO_ORDER_FILE, &read), CLEFT_OK);
            assert_int_equal(cleft_sizing_affine(read, read_affine), CLEFT_OK);
            for (int a = 0; a < 12; ++a)
                assert_true(fabs(read_affine[a] - affine[a]) < 1e-6);
            assert_metric(read, 1);
            cleft_sizing_destroy(read);
            cleft_sizing_destroy(sizing);
            cleft_volume_destroy(volume);
        }
}

static void test_metrics_need_a_format_and_a_grid(void** state)
{
    fixture* f = *state;
    static const double affine[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0},
                        shifted[12] = {1, 0, 0, 0, 0, 1, 0, 0.1, 0, 0, 1, 0};
    cleft_volume *volume = make_volume(f, affine), *other = make_volume(f, shifted);
    cleft_sizing *sizing = make_metric(f, volume), *read = NULL;
    static const char* const names[] = {"m.nii", "m.nii.gz", "m.mha", "m.png"};
    for (int i = 0; i < 4; ++i)
        assert_refused(f, cleft_io_write_sizing(f->context, sizing, path_of(f, names[i]), 0), CLEFT_ERROR_UNSUPPORTED,
                       ".nrrd or .vtk");
    assert_int_equal(cleft_io_write_sizing(f->context, sizing, path_of(f, "m.nrrd"), 0), CLEFT_OK);
    assert_refused(f, read_metric(f, other, NULL, CLEFT_IO_ORDER_FILE, &read), CLEFT_ERROR_ARGUMENT, "places");
    assert_refused(f, read_metric(f, volume, NULL, CLEFT_IO_ORDER_VTK, &read), CLEFT_ERROR_FORMAT, "nrrd");
    assert_refused(f, read_metric(f, volume, NULL, 4, &read), CLEFT_ERROR_ARGUMENT, "order 4");
    assert_refused(f, cleft_io_read_sizing(f->context, volume, f->path, NULL, 0, NULL, &read), CLEFT_ERROR_FORMAT,
                   "3d-symmetric-matrix");
    /* Lengths of a thousandth have a metric of a million. */
    static const double small[12] = {1e-3, 0, 0, 0, 0, 1e-3, 0, 0, 0, 0, 1e-3, 0};
    const cleft_io_reading reading = {.struct_size = sizeof reading, .scale = 1e-3};
    cleft_volume* scaled = make_volume(f, small);
    assert_int_equal(read_metric(f, scaled, &reading, CLEFT_IO_ORDER_FILE, &read), CLEFT_OK);
    assert_metric(read, 1e6);
    cleft_sizing_destroy(read);
    cleft_volume_destroy(scaled);
    cleft_volume_destroy(other);
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
}

/* One voxel, in text: what is read of it, or the words of the refusal. */
static void check_text(fixture* f, const char* head, const char* numbers, cleft_io_tensor_order order,
                       const double wanted[6], const char* words)
{
    cleft_sizing* read = NULL;
    float back[6];
    write_file(path_of(f, strstr(head, "NRRD") ? "t.nrrd" : "t.vtk"), head, strlen(head), numbers, strlen(numbers));
    const cleft_status status = read_metric(f, NULL, NULL, order, &read);
    if (!wanted) {
        assert_refused(f, status, status, words);
        assert_true(status == CLEFT_ERROR_FORMAT || status == CLEFT_ERROR_UNSUPPORTED ||
                    status == CLEFT_ERROR_ARGUMENT || status == CLEFT_ERROR_NOT_FINITE);
        assert_null(read);
        return;
    }
    if (status != CLEFT_OK)
        fail_msg("%s", cleft_context_last_error(f->context));
    assert_int_equal(cleft_sizing_copy_metric(read, back, 6), CLEFT_OK);
    for (int c = 0; c < 6; ++c)
        assert_true(fabs(back[c] - wanted[c]) < 1e-5);
    cleft_sizing_destroy(read);
}

#define NRRD_HEAD(size) "NRRD0005\ntype: double\ndimension: 4\nencoding: text\nsizes: " size " 1 1 1\n"
#define KINDS(kind) "kinds: " kind " domain domain domain\n"

/* The same tensor in each order. */
static void test_orders(void** state)
{
    static const double wanted[6] = {2, 0.1, 0.2, 3, 0.3, 4};
    fixture* f = *state;
    const char* symmetric = NRRD_HEAD("6") KINDS("3D-symmetric-matrix") "\n";
    check_text(f, symmetric, "2 .1 .2 3 .3 4", CLEFT_IO_ORDER_FILE, wanted, NULL);
    check_text(f, symmetric, "2 .1 .2 3 .3 4", CLEFT_IO_ORDER_NRRD, wanted, NULL);
    const char* masked = NRRD_HEAD("7") KINDS("3D-masked-symmetric-matrix") "\n";
    check_text(f, masked, "1 2 .1 .2 3 .3 4", CLEFT_IO_ORDER_FILE, wanted, NULL);
    check_text(f, masked, "0 2 .1 .2 3 .3 4", CLEFT_IO_ORDER_FILE, NULL, "the mask of the voxel that is the 1st");
    check_text(f, NRRD_HEAD("7") "\n", "1 2 .1 .2 3 .3 4", CLEFT_IO_ORDER_FILE, NULL, "mask");
    const char* full = NRRD_HEAD("9") KINDS("3D-matrix") "\n";
    check_text(f, full, "2 .1 .2 .1 3 .3 .2 .3 4", CLEFT_IO_ORDER_FILE, wanted, NULL);
    check_text(f, full, "2 .1 .2 .1 3 .4 .2 .3 4", CLEFT_IO_ORDER_FILE, NULL, "not symmetric: its yz and zy are 0.4");
    check_text(f, full, "2 .1 .2 .1 nan .3 .2 .3 4", CLEFT_IO_ORDER_FILE, NULL, "NaN");
    check_text(f, full, "2 .1 .2 .1 -3 .3 .2 .3 4", CLEFT_IO_ORDER_FILE, NULL, "not positive definite");
    const char* silent = NRRD_HEAD("6") "\n";
    check_text(f, silent, "2 .1 .2 3 .3 4", CLEFT_IO_ORDER_FILE, NULL, "in which order");
    check_text(f, silent, "2 .1 .2 3 .3 4", CLEFT_IO_ORDER_NRRD, wanted, NULL);
    check_text(f, silent, "2 3 4 .1 .3 .2", CLEFT_IO_ORDER_VTK, wanted, NULL);
    check_text(f, silent, "2 .1 3 .2 .3 4", CLEFT_IO_ORDER_NIFTI, wanted, NULL);
    check_text(f, NRRD_HEAD("5") "\n", "2 .1 .2 3 .3", CLEFT_IO_ORDER_FILE, NULL, "5 numbers a voxel");
    const char* grid =
        "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 1 1 1\n"
        "ORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 1\n";
    char head[400];
    snprintf(head, sizeof head, "%sTENSORS m double\n", grid);
    check_text(f, head, "2 .1 .2 .1 3 .3 .2 .3 4\n", CLEFT_IO_ORDER_FILE, wanted, NULL);
    snprintf(head, sizeof head, "%sTENSORS6 m double\n", grid);
    check_text(f, head, "2 3 4 .1 .3 .2\n", CLEFT_IO_ORDER_FILE, wanted, NULL);
    snprintf(head, sizeof head, "%sFIELD f 1\nm 6 1 double\n", grid);
    check_text(f, head, "2 3 4 .1 .3 .2\n", CLEFT_IO_ORDER_FILE, wanted, NULL);
    snprintf(head, sizeof head, "%sSCALARS m double\nLOOKUP_TABLE default\n", grid);
    check_text(f, head, "2\n", CLEFT_IO_ORDER_FILE, NULL, "0 arrays of six or nine");
}

/* Tensors are turned into the world out of the coordinates that the file has them in. */
static void test_frames(void** state)
{
    static const double as_written[6] = {2, 0.1, 0.2, 3, 0.3, 4}, ras[6] = {2, 0.1, -0.2, 3, -0.3, 4};
    /* x of the tensor goes along y, y along -x. */
    static const double turned[6] = {3, -0.1, -0.3, 2, 0.2, 4};
    fixture* f = *state;
    char head[600];
#define PLACED "NRRD0005\ntype: double\ndimension: 4\nencoding: text\nsizes: 6 1 1 1\n" KINDS("3D-symmetric-matrix")
#define DIRECTIONS "space directions: none (1,0,0) (0,1,0) (0,0,1)\n"
    const struct {
        const char *space, *frame;
        const double* wanted;
        const char* words;
    } cases[] = {{"lps", "", as_written, NULL},
                 {"ras", "", ras, NULL},
                 {"lps", "measurement frame: (1,0,0) (0,1,0) (0,0,1)\n", as_written, NULL},
                 {"lps", "measurement frame: (0,1,0) (-1,0,0) (0,0,1)\n", turned, NULL},
                 {"lps", "measurement frame: (2,0,0) (0,1,0) (0,0,1)\n", NULL, "right angles"},
                 {"lps", "measurement frame: (1,0,0) (0,1,0)\n", NULL, "three vectors"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        snprintf(head, sizeof head, PLACED "space: %s\n" DIRECTIONS "%s\n", cases[i].space, cases[i].frame);
        check_text(f, head, "2 .1 .2 3 .3 4", CLEFT_IO_ORDER_FILE, cases[i].wanted, cases[i].words);
    }
}

/* Two voxels: the lower triangle by rows, number after number; in RAS. */
static void test_nifti(void** state)
{
    fixture* f = *state;
    unsigned char head[352] = {0};
    const int32_t size = 348;
    const float begin = 352, pixdim[8] = {1, 1, 1, 1, 1, 1, 1, 1};
    const float numbers[12] = {2, 2.5f, 0.1f, 0.1f, 3, 3, 0.2f, 0.2f, 0.3f, 0.3f, 4, 4};
    int16_t dim[8] = {5, 2, 1, 1, 1, 6, 1, 1}, intent = 1005, type = 16, bits = 32;
    memcpy(head, &size, 4);
    memcpy(head + 68, &intent, 2);
    memcpy(head + 70, &type, 2);
    memcpy(head + 72, &bits, 2);
    memcpy(head + 76, pixdim, sizeof pixdim);
    memcpy(head + 108, &begin, 4);
    memcpy(head + 344, "n+1", 4);
    for (int i = 0; i < 2; ++i) {
        cleft_sizing* read = NULL;
        float back[12];
        memcpy(head + 40, dim, sizeof dim);
        write_file(path_of(f, "t.nii"), head, sizeof head, numbers, sizeof numbers);
        assert_int_equal(read_metric(f, NULL, NULL, i == 0 ? CLEFT_IO_ORDER_FILE : CLEFT_IO_ORDER_NIFTI, &read),
                         CLEFT_OK);
        assert_int_equal(cleft_sizing_copy_metric(read, back, 12), CLEFT_OK);
        const float wanted[6] = {2.5f, 0.1f, -0.2f, 3, -0.3f, 4};
        for (int c = 0; c < 6; ++c)
            assert_true(fabsf(back[6 + c] - wanted[c]) < 1e-5f);
        cleft_sizing_destroy(read);
        /* The fourth dimension, and nothing said of the order. */
        dim[0] = 4;
        dim[4] = 6;
        dim[5] = 1;
        memset(head + 68, 0, 2);
    }
    cleft_sizing* read = NULL;
    assert_refused(f, read_metric(f, NULL, NULL, CLEFT_IO_ORDER_FILE, &read), CLEFT_ERROR_FORMAT, "in which order");
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {TEST(test_metrics_come_back), TEST(test_metrics_need_a_format_and_a_grid),
                                       TEST(test_orders), TEST(test_frames), TEST(test_nifti)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
