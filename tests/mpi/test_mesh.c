/* Run by mpirun on some number of ranks, with a folder: parts are those of the mesh of one process, and files come
 * whole or not at all. check_vtk.py compares the files that runs of several numbers leave there. */
#include "cleft/cleft_io.h"
#include "cleft/cleft_mpi.h"
#include "support/capi.h"
#include "support/part_counts.h"

#include <dirent.h>
#include <hdf5.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char* folder;
static int rank, ranks;

enum { SIDE = 12 };

static int32_t label_at(int64_t i, int64_t j, int64_t k)
{
    const int64_t x = 2 * i - SIDE, y = 2 * j - SIDE, z = 2 * k - SIDE;
    return x * x + y * y + z * z < SIDE * SIDE / 2 ? 7 : x < 0 ? 3 : -2;
}

typedef struct {
    int64_t side;
    int fails;
} labels;

static int read_labels(const int64_t first[3], const int64_t count[3], void* voxels, char* sentence, int64_t room,
                       void* user)
{
    int32_t* out = (int32_t*)voxels;
    if (((const labels*)user)->fails) {
        snprintf(sentence, (size_t)room, "the tape is worn");
        return 1;
    }
    for (int64_t k = first[2]; k < first[2] + count[2]; ++k)
        for (int64_t j = first[1]; j < first[1] + count[1]; ++j)
            for (int64_t i = first[0]; i < first[0] + count[0]; ++i)
                *out++ = label_at(i, j, k);
    return 0;
}

static cleft_voxels voxels_of(labels* user)
{
    cleft_voxels v = {sizeof(cleft_voxels), CLEFT_TYPE_INT32, {user->side, user->side, user->side}, {0}, user,
                      read_labels};
    v.affine[0] = 1, v.affine[5] = 1.5, v.affine[10] = 0.5;
    v.affine[3] = -4;
    return v;
}

static cleft_mesh* whole_mesh(cleft_context* context, const cleft_voxels* voxels)
{
    static int32_t labels_of[SIDE * SIDE * SIDE];
    const int64_t first[3] = {0, 0, 0};
    cleft_volume* volume = NULL;
    cleft_mesh* mesh = NULL;
    assert_int_equal(voxels->read(first, voxels->dims, labels_of, NULL, 0, voxels->user), 0);
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_INT32, labels_of, voxels->dims, voxels->affine,
                                                  NULL, &volume));
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, NULL, &mesh));
    cleft_volume_destroy(volume);
    return mesh;
}

static void assert_part_of(const cleft_part* part, const cleft_mesh* whole)
{
    const cleft_part_counts n = counts_of(part);
    const int64_t* numbers = cleft_part_point_numbers(part);
    assert_int_equal(n.rank, rank);
    assert_int_equal(n.ranks, ranks);
    assert_int_equal(n.all_points, cleft_mesh_point_count(whole));
    assert_int_equal(n.all_tets, cleft_mesh_tet_count(whole));
    for (int64_t p = 0; p < n.points; ++p)
        assert_memory_equal(cleft_part_points(part) + 3 * p, cleft_mesh_points(whole) + 3 * numbers[p], 24);
    for (int64_t t = 0; t < n.tets; ++t) {
        const int64_t number = cleft_part_tet_numbers(part)[t];
        assert_true(t < n.owned_tets ? number == n.first_tet + t : cleft_part_tet_owners(part)[t] != rank);
        assert_int_equal(cleft_part_tet_labels(part)[t], cleft_mesh_tet_labels(whole)[number]);
        for (int c = 0; c < 4; ++c)
            assert_int_equal(numbers[cleft_part_tets(part)[4 * t + c]], cleft_mesh_tets(whole)[4 * number + c]);
    }
}

/* All ranks hear of the whole mesh. */
static void assert_quality_of(cleft_context* context, const cleft_part* part, const cleft_mesh* whole)
{
    cleft_quality found, expected;
    memset(&found, 0, sizeof found);
    memset(&expected, 0, sizeof expected);
    found.struct_size = expected.struct_size = sizeof found;
    assert_ok(context, cleft_mpi_quality(context, MPI_COMM_WORLD, part, &found));
    assert_ok(context, cleft_mesh_quality(context, whole, &expected));
    assert_true(fabs(found.mean_edge - expected.mean_edge) <= 1e-12 * expected.mean_edge);
    assert_true(fabs(found.total_volume - expected.total_volume) <= 1e-12 * expected.total_volume);
    found.mean_edge = expected.mean_edge;
    found.total_volume = expected.total_volume;
    assert_memory_equal(&found, &expected, sizeof found);
}

static char* path_of(const char* name)
{
    static char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

/* A name for this number of ranks. */
static char* own_path(const char* extension)
{
    char name[100];
    snprintf(name, sizeof name, "%d%s", ranks, extension);
    return path_of(name);
}

static void parts_are_the_whole(void** state)
{
    cleft_context* context = new_context();
    labels user = {SIDE, 0};
    const cleft_voxels voxels = voxels_of(&user);
    cleft_mesh* whole = whole_mesh(context, &voxels);
    (void)state;
    for (int32_t ghosts = 0; ghosts < 2; ++ghosts) {
        cleft_part* part = NULL;
        assert_ok(context, cleft_mpi_mesh(context, MPI_COMM_WORLD, &voxels, NULL, ghosts, &part));
        assert_part_of(part, whole);
        assert_quality_of(context, part, whole);
        assert_ok(context, cleft_mpi_write(context, MPI_COMM_WORLD, part, own_path(ghosts ? "g.vtkhdf" : ".vtkhdf")));
        assert_ok(context, cleft_mpi_write(context, MPI_COMM_WORLD, part, own_path(ghosts ? "g.pvtu" : ".pvtu")));
        assert_ok(context, cleft_mpi_write(context, MPI_COMM_WORLD, part, own_path(ghosts ? "g.mfem" : ".mfem")));
        /* Once more, over what is there. */
        assert_ok(context, cleft_mpi_write(context, MPI_COMM_WORLD, part, own_path(ghosts ? "g.vtkhdf" : ".vtkhdf")));
        cleft_part_destroy(part);
    }
    if (rank == 0)
        assert_ok(context, cleft_io_write_mesh(context, whole, own_path(".vtu"), CLEFT_FORMAT_BY_NAME));
    cleft_mesh_destroy(whole);
    cleft_context_destroy(context);
}

/* With one voxel there are more ranks than points. */
static void some_ranks_have_nothing(void** state)
{
    cleft_context* context = new_context();
    labels user = {1, 0};
    const cleft_voxels voxels = voxels_of(&user);
    cleft_mesh* whole = whole_mesh(context, &voxels);
    cleft_part* part = NULL;
    (void)state;
    assert_ok(context, cleft_mpi_mesh(context, MPI_COMM_WORLD, &voxels, NULL, 0, &part));
    assert_part_of(part, whole);
    assert_quality_of(context, part, whole);
    assert_ok(context, cleft_mpi_write(context, MPI_COMM_WORLD, part, own_path("one.hdf")));
    assert_ok(context, cleft_mpi_write(context, MPI_COMM_WORLD, part, own_path("one.pvtu")));
    assert_ok(context, cleft_mpi_write(context, MPI_COMM_WORLD, part, own_path("one.mfem")));
    cleft_part_destroy(part);
    cleft_mesh_destroy(whole);
    cleft_context_destroy(context);
}

static void failures_are_those_of_all(void** state)
{
    cleft_context* context = new_context();
    labels user = {4, rank == 0};
    const cleft_voxels voxels = voxels_of(&user);
    cleft_part* part = NULL;
    (void)state;
    assert_int_equal(cleft_mpi_mesh(context, MPI_COMM_WORLD, &voxels, NULL, 0, &part), CLEFT_ERROR_FILE);
    assert_string_equal(cleft_context_last_error(context), ranks > 1 ? "rank 0: the tape is worn" : "the tape is worn");
    assert_null(part);
    user.fails = 0;
    assert_ok(context, cleft_mpi_mesh(context, MPI_COMM_WORLD, &voxels, NULL, 0, &part));
    assert_int_equal(cleft_mpi_write(context, MPI_COMM_WORLD, part, own_path(".obj")), CLEFT_ERROR_UNSUPPORTED);
    assert_int_equal(cleft_mpi_write(context, MPI_COMM_WORLD, part, path_of("none/mesh.pvtu")), CLEFT_ERROR_FILE);
    assert_non_null(strstr(cleft_context_last_error(context), "none/mesh.pvtu': No such file or directory"));
    assert_int_equal(cleft_mpi_write(context, MPI_COMM_WORLD, rank == ranks - 1 ? NULL : part, own_path("no.vtkhdf")),
                     CLEFT_ERROR_NULL);
    assert_int_not_equal(access(own_path("no.vtkhdf"), F_OK), 0);
    assert_int_equal(cleft_mpi_quality(context, MPI_COMM_WORLD, part, NULL), CLEFT_ERROR_NULL);
    assert_int_equal(cleft_mpi_write(context, MPI_COMM_NULL, part, own_path("no.vtkhdf")), CLEFT_ERROR_ARGUMENT);
    cleft_part_destroy(part);
    cleft_context_destroy(context);
}

static void all_files_are_written_or_none(void** state)
{
    cleft_context* context = new_context();
    labels user = {4, 0};
    const cleft_voxels voxels = voxels_of(&user);
    cleft_part* part = NULL;
    char first[256], second[256];
    const char* paths[2] = {first, second};
    (void)state;
    strcpy(first, own_path("all.vtkhdf"));
    strcpy(second, path_of("none/all.pvtu"));
    // An earlier run may have left it.
    if (rank == 0)
        (void)unlink(first);
    assert_ok(context, cleft_mpi_mesh(context, MPI_COMM_WORLD, &voxels, NULL, 0, &part));
    assert_int_equal(cleft_mpi_write_all(context, MPI_COMM_WORLD, part, paths, 2), CLEFT_ERROR_FILE);
    assert_int_not_equal(access(first, F_OK), 0);
    strcpy(second, own_path("all.obj"));
    assert_int_equal(cleft_mpi_write_all(context, MPI_COMM_WORLD, part, paths, 2), CLEFT_ERROR_UNSUPPORTED);
    assert_int_not_equal(access(first, F_OK), 0);
    assert_int_equal(cleft_mpi_write_all(context, MPI_COMM_WORLD, part, paths, 0), CLEFT_ERROR_ARGUMENT);
    assert_int_equal(cleft_mpi_write_all(context, MPI_COMM_WORLD, part, NULL, 2), CLEFT_ERROR_NULL);
    strcpy(second, own_path("all.pvtu"));
    // Those of rank 0 count.
    assert_ok(context, cleft_mpi_write_all(context, MPI_COMM_WORLD, part, rank == 0 ? paths : NULL, rank == 0 ? 2 : 0));
    assert_int_equal(access(first, F_OK), 0);
    assert_int_equal(access(second, F_OK), 0);
    /* A folder does not give its place to a piece, and keeps what is in it. */
    strcpy(second, own_path("folder_0000.vtu"));
    if (rank == 0)
        mkdir(second, 0777);
    strcpy(second, own_path("folder_0000.vtu/kept"));
    if (rank == 0)
        mkdir(second, 0777);
    assert_int_equal(cleft_mpi_write(context, MPI_COMM_WORLD, part, own_path("folder.pvtu")), CLEFT_ERROR_FILE);
    assert_non_null(strstr(cleft_context_last_error(context), "folder_0000.vtu': it is no regular file"));
    assert_int_equal(access(second, F_OK), 0);
    assert_int_not_equal(access(own_path("folder.pvtu"), F_OK), 0);
    cleft_part_destroy(part);
    cleft_context_destroy(context);
}

static void a_part_belongs_to_its_ranks(void** state)
{
    cleft_context* context = new_context();
    labels user = {4, 0};
    const cleft_voxels voxels = voxels_of(&user);
    cleft_part* part = NULL;
    cleft_quality quality;
    (void)state;
    assert_ok(context, cleft_mpi_mesh(context, MPI_COMM_SELF, &voxels, NULL, 0, &part));
    assert_int_equal(counts_of(part).ranks, 1);
    quality.struct_size = sizeof quality;
    if (ranks > 1) {
        assert_int_equal(cleft_mpi_quality(context, MPI_COMM_WORLD, part, &quality), CLEFT_ERROR_ARGUMENT);
        assert_non_null(strstr(cleft_context_last_error(context), "rank 0: the part is that of rank 0 of 1"));
        assert_int_equal(cleft_mpi_write(context, MPI_COMM_WORLD, part, own_path("no.vtkhdf")), CLEFT_ERROR_ARGUMENT);
        assert_non_null(strstr(cleft_context_last_error(context), "rank 0: the part is that of rank 0 of 1"));
    }
    cleft_part_destroy(part);
    cleft_context_destroy(context);
}

static void an_exchange_opens_and_closes(void** state)
{
    cleft_exchange exchange;
    int64_t send[64], receive[64];
    (void)state;
    memset(&exchange, 0, sizeof exchange);
    cleft_mpi_exchange_close(&exchange);
    cleft_mpi_exchange_close(NULL);
    assert_int_equal(cleft_mpi_exchange_open(MPI_COMM_WORLD, &exchange), CLEFT_ERROR_ARGUMENT);
    exchange.struct_size = sizeof exchange;
    assert_int_equal(cleft_mpi_exchange_open(MPI_COMM_WORLD, &exchange), CLEFT_OK);
    assert_int_equal(exchange.rank, rank);
    assert_int_equal(exchange.ranks, ranks);
    for (int r = 0; r < ranks; ++r)
        send[r] = 100 * rank + r;
    assert_int_equal(exchange.numbers(send, receive, exchange.user), 0);
    for (int r = 0; r < ranks; ++r)
        assert_int_equal(receive[r], 100 * r + rank);
    cleft_mpi_exchange_close(&exchange);
    assert_null((void*)exchange.user);
}

static void add_attribute(hid_t data, const char* name, double x, double y, double z)
{
    const hsize_t three = 3;
    const double values[3] = {x, y, z};
    const hid_t space = H5Screate_simple(1, &three, NULL);
    const hid_t attribute = H5Acreate2(data, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT);
    assert_true(H5Awrite(attribute, H5T_NATIVE_DOUBLE, values) >= 0);
    H5Aclose(attribute);
    H5Sclose(space);
}

/* Labels of 64 bits and of 8; one data set with attributes, the other without. */
static void write_hdf5(const char* path, int is_second)
{
    const hsize_t extent[3] = {3, 4, 5};
    int64_t values[60];
    const hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t space = H5Screate_simple(3, extent, NULL);
    const hid_t data = H5Dcreate2(file, "labels", is_second ? H5T_STD_U8LE : H5T_STD_I64BE, space, H5P_DEFAULT,
                                  H5P_DEFAULT, H5P_DEFAULT);
    for (int i = 0; i < 60; ++i)
        values[i] = i;
    assert_true(H5Dwrite(data, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
    if (is_second) {
        const hid_t other = H5Dcreate2(file, "more", H5T_STD_I32LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        H5Dclose(other);
    } else {
        add_attribute(data, "spacing", 0.5, 2, 3);
        add_attribute(data, "origin", -1, -2, -3);
    }
    H5Dclose(data);
    H5Sclose(space);
    H5Fclose(file);
}

static void hdf5_volumes_are_read(void** state)
{
    static const double kSpacing[3] = {2, 2, 2};
    cleft_context* context = new_context();
    cleft_voxels voxels;
    const int64_t first[3] = {1, 2, 0}, count[3] = {2, 1, 3};
    int32_t box[6];
    uint8_t small[6];
    char name[100], sentence[200] = "";
    (void)state;
    memset(&voxels, 0, sizeof voxels);
    voxels.struct_size = sizeof voxels;
    snprintf(name, sizeof name, "%d-%d.h5", ranks, rank);
    write_hdf5(path_of(name), 0);
    assert_ok(context, cleft_mpi_voxels_open(context, path_of(name), NULL, NULL, &voxels));
    assert_int_equal(voxels.type, CLEFT_TYPE_INT32);
    assert_int_equal(voxels.dims[0], 5);
    assert_int_equal(voxels.dims[2], 3);
    assert_true(voxels.affine[0] == 0.5 && voxels.affine[5] == 2 && voxels.affine[10] == 3);
    assert_true(voxels.affine[3] == -1 && voxels.affine[11] == -3);
    assert_int_equal(voxels.read(first, count, box, sentence, sizeof sentence, voxels.user), 0);
    for (int i = 0; i < 6; ++i)
        assert_int_equal(box[i], 1 + i % 2 + 5 * 2 + 20 * (i / 2));
    cleft_mpi_voxels_close(&voxels);
    cleft_mpi_voxels_close(&voxels);
    assert_null((void*)voxels.user);

    write_hdf5(path_of(name), 1);
    assert_int_equal(cleft_mpi_voxels_open(context, path_of(name), NULL, NULL, &voxels), CLEFT_ERROR_FORMAT);
    assert_non_null(strstr(cleft_context_last_error(context), "labels, more"));
    assert_int_equal(cleft_mpi_voxels_open(context, path_of(name), "none", NULL, &voxels), CLEFT_ERROR_FORMAT);
    assert_int_equal(cleft_mpi_voxels_open(context, path_of("none.h5"), NULL, NULL, &voxels), CLEFT_ERROR_FILE);
    assert_ok(context, cleft_mpi_voxels_open(context, path_of(name), "labels", kSpacing, &voxels));
    assert_int_equal(voxels.type, CLEFT_TYPE_UINT8);
    assert_true(voxels.affine[10] == 2);
    assert_int_equal(voxels.read(first, count, small, sentence, sizeof sentence, voxels.user), 0);
    assert_int_equal(small[5], 52);
    cleft_mpi_voxels_close(&voxels);
    unlink(path_of(name));
    cleft_context_destroy(context);
}

/* For test_command.py. */
static void a_volume_is_left(void** state)
{
    const hsize_t extent[3] = {SIDE, SIDE, SIDE};
    const int64_t first[3] = {0, 0, 0}, count[3] = {SIDE, SIDE, SIDE};
    int32_t values[SIDE * SIDE * SIDE];
    labels user = {SIDE, 0};
    (void)state;
    if (ranks > 1)
        return;
    assert_int_equal(read_labels(first, count, values, NULL, 0, &user), 0);
    const hid_t file = H5Fcreate(path_of("volume.h5"), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t space = H5Screate_simple(3, extent, NULL);
    const hid_t data = H5Dcreate2(file, "labels", H5T_STD_I32LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    assert_true(H5Dwrite(data, H5T_NATIVE_INT32, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
    add_attribute(data, "spacing", 1, 1.5, 0.5);
    add_attribute(data, "origin", -4, 0, 0);
    H5Dclose(data);
    H5Sclose(space);
    H5Fclose(file);
}

/* No folder in which files wait for their names is left. */
static void nothing_is_left(void** state)
{
    (void)state;
    MPI_Barrier(MPI_COMM_WORLD);
    if (rank == 0) {
        DIR* listing = opendir(folder);
        assert_non_null(listing);
        for (struct dirent* entry; (entry = readdir(listing));)
            assert_null(strstr(entry->d_name, ".cleft-mpi-"));
        closedir(listing);
    }
}

int main(int argc, char** argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_exchange_opens_and_closes),
        cmocka_unit_test(parts_are_the_whole),
        cmocka_unit_test(some_ranks_have_nothing),
        cmocka_unit_test(failures_are_those_of_all),
        cmocka_unit_test(all_files_are_written_or_none),
        cmocka_unit_test(a_part_belongs_to_its_ranks),
        cmocka_unit_test(hdf5_volumes_are_read),
        cmocka_unit_test(a_volume_is_left),
        cmocka_unit_test(nothing_is_left),
    };
    int provided = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    folder = argc > 1 ? argv[1] : ".";
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    /* Others may wait for a rank that failed. */
    if (failed)
        MPI_Abort(MPI_COMM_WORLD, 1);
    MPI_Finalize();
    return 0;
}
