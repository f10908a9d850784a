/* Meshes to files and back: every bit, all or nothing, and no crash on what is damaged. */
#include "folder.h"
#include "io/sample_mesh.h"

#include <errno.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

typedef struct fixture {
    cleft_context* context;
    cleft_mesh* mesh;
    char folder[FOLDER_NAME];
    char path[128]; /* of the last path_of() */
} fixture;

static const char* path_of(fixture* f, const char* name)
{
    snprintf(f->path, sizeof f->path, "%s/%s", f->folder, name);
    return f->path;
}

static int set_up(void** state)
{
    fixture* f = calloc(1, sizeof *f);
    if (make_folder(f->folder, &f->context) != 0)
        return -1;
    f->mesh = sample_mesh_create(f->context);
    *state = f;
    return f->mesh ? 0 : -1;
}

static int tear_down(void** state)
{
    fixture* f = *state;
    const int removed = remove_folder(f->folder);
    cleft_mesh_destroy(f->mesh);
    cleft_context_destroy(f->context);
    free(f);
    return removed;
}

static int64_t file_count(fixture* f)
{
    char command[128];
    int count = -1;
    snprintf(command, sizeof command, "ls -A %s | wc -l", f->folder);
    FILE* pipe = popen(command, "r");
    if (pipe && fscanf(pipe, "%d", &count) != 1)
        count = -1;
    if (pipe)
        pclose(pipe);
    return count;
}

/* The whole file, with a 0 behind it; NULL if there is none. */
static char* read_file(const char* path, size_t* size)
{
    FILE* file = fopen(path, "rb");
    if (!file)
        return NULL;
    fseek(file, 0, SEEK_END);
    *size = (size_t)ftell(file);
    rewind(file);
    char* data = calloc(*size + 1, 1);
    const size_t got = fread(data, 1, *size, file);
    fclose(file);
    return got == *size ? data : NULL;
}

static void write_file(const char* path, const void* data, size_t size)
{
    FILE* file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(data, 1, size, file), size);
    fclose(file);
}

static const char* const readable[] = {"a.vtu", "a.vtk", "a.mesh", "a.msh", "a.node"};
enum { READABLE = sizeof readable / sizeof *readable };

static void test_round_trip_keeps_every_bit(void** state)
{
    fixture* f = *state;
    for (int i = 0; i < READABLE; ++i) {
        const char* path = path_of(f, readable[i]);
        const int by_entity = strcmp(readable[i], "a.msh") == 0; /* version 4.1 has another order */
        assert_int_equal(
            cleft_io_write_mesh(f->context, f->mesh, path, by_entity ? CLEFT_FORMAT_MSH22 : CLEFT_FORMAT_BY_NAME),
            CLEFT_OK);
        cleft_mesh* read = NULL;
        assert_int_equal(cleft_io_read_mesh(f->context, path, &read), CLEFT_OK);
        assert_int_equal(cleft_mesh_point_count(read), SAMPLE_POINTS);
        assert_int_equal(cleft_mesh_tet_count(read), SAMPLE_TETS);
        assert_memory_equal(cleft_mesh_points(read), cleft_mesh_points(f->mesh), 3 * SAMPLE_POINTS * sizeof(double));
        assert_memory_equal(cleft_mesh_tets(read), cleft_mesh_tets(f->mesh), 4 * SAMPLE_TETS * sizeof(int32_t));
        assert_memory_equal(cleft_mesh_tet_labels(read), cleft_mesh_tet_labels(f->mesh), SAMPLE_TETS * sizeof(int32_t));
        cleft_mesh_destroy(read);
    }
}

/* Many copies of the sample beside each other: arrays of several blocks, which threads share. */
static cleft_mesh* make_large_mesh(cleft_context* context)
{
    enum { COPIES = 200 };
    sample_mesh sample;
    cleft_mesh* mesh = NULL;
    double* points = malloc(COPIES * sizeof sample.points);
    int32_t* tets = malloc(COPIES * sizeof sample.tets);
    int32_t* labels = malloc(COPIES * sizeof sample.labels);
    sample_mesh_fill(&sample);
    for (int copy = 0; copy < COPIES; ++copy) {
        for (int i = 0; i < 3 * SAMPLE_POINTS; ++i)
            points[copy * 3 * SAMPLE_POINTS + i] = sample.points[i] + (i % 3 == 0 ? 10 * copy : 0);
        for (int i = 0; i < 4 * SAMPLE_TETS; ++i)
            tets[copy * 4 * SAMPLE_TETS + i] = sample.tets[i] + copy * SAMPLE_POINTS;
        memcpy(labels + copy * SAMPLE_TETS, sample.labels, sizeof sample.labels);
    }
    assert_int_equal(
        cleft_mesh_create(context, COPIES * SAMPLE_POINTS, points, COPIES * SAMPLE_TETS, tets, labels, 0, &mesh), 0);
    free(points);
    free(tets);
    free(labels);
    return mesh;
}

static void test_same_bytes_for_any_number_of_threads(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_large_mesh(f->context);
    assert_non_null(mesh);
    size_t sizes[2];
    char* data[2];
    for (int threads = 1; threads <= 2; ++threads) {
        assert_int_equal(cleft_context_set_threads(f->context, threads), CLEFT_OK);
        assert_int_equal(cleft_io_write_mesh(f->context, mesh, path_of(f, "t.vtu"), CLEFT_FORMAT_VTU), CLEFT_OK);
        data[threads - 1] = read_file(f->path, &sizes[threads - 1]);
        assert_non_null(data[threads - 1]);
    }
    assert_int_equal(sizes[0], sizes[1]);
    assert_memory_equal(data[0], data[1], sizes[0]);
    free(data[0]);
    free(data[1]);
    cleft_mesh* read = NULL;
    assert_int_equal(cleft_io_read_mesh(f->context, f->path, &read), CLEFT_OK);
    assert_int_equal(cleft_mesh_tet_count(read), cleft_mesh_tet_count(mesh));
    assert_memory_equal(cleft_mesh_tets(read), cleft_mesh_tets(mesh),
                        4 * (size_t)cleft_mesh_tet_count(mesh) * sizeof(int32_t));
    cleft_mesh_destroy(read);
    cleft_mesh_destroy(mesh);
}

static void assert_refused(fixture* f, cleft_status status, cleft_status wanted, const char* words)
{
    assert_int_equal(status, wanted);
    if (!strstr(cleft_context_last_error(f->context), words))
        fail_msg("'%s' does not say '%s'", cleft_context_last_error(f->context), words);
}

static void test_wrong_arguments(void** state)
{
    fixture* f = *state;
    cleft_mesh* out = f->mesh;
    assert_int_equal(cleft_io_write_mesh(NULL, f->mesh, path_of(f, "a.vtu"), 0), CLEFT_ERROR_NULL);
    assert_refused(f, cleft_io_write_mesh(f->context, NULL, f->path, 0), CLEFT_ERROR_NULL, "mesh");
    assert_refused(f, cleft_io_write_mesh(f->context, f->mesh, NULL, 0), CLEFT_ERROR_NULL, "path");
    assert_refused(f, cleft_io_write_mesh(f->context, f->mesh, f->path, 99), CLEFT_ERROR_ARGUMENT, "format 99");
    assert_refused(f, cleft_io_write_mesh(f->context, f->mesh, "x.xyz", 0), CLEFT_ERROR_ARGUMENT, ".vtu");
    assert_refused(f, cleft_io_write_mesh(f->context, f->mesh, f->path, CLEFT_FORMAT_VTKHDF), CLEFT_ERROR_ARGUMENT,
                   "format 11");
    assert_refused(f, cleft_io_write_mesh(f->context, f->mesh, "x.vtkhdf", 0), CLEFT_ERROR_ARGUMENT, ".vtu");
    assert_refused(f, cleft_io_read_mesh(f->context, "x.stl", &out), CLEFT_ERROR_ARGUMENT, ".vtu");
    assert_null(out);
    assert_refused(f, cleft_io_read_mesh(f->context, path_of(f, "none.vtu"), &out), CLEFT_ERROR_FILE, "none.vtu");
    assert_refused(f, cleft_io_read_mesh(f->context, f->path, NULL), CLEFT_ERROR_NULL, "out");
    assert_int_equal(file_count(f), 0);
}

static void test_table_of_formats(void** state)
{
    (void)state;
    cleft_io_format_description row = {.struct_size = sizeof row};
    int meshes = 0;
    for (int32_t i = 0; i < cleft_io_format_count(); ++i) {
        assert_int_equal(cleft_io_format_info(i, &row), CLEFT_OK);
        assert_true(row.directions != 0 && row.name[0] && row.extensions[0] == '.' && row.text[0]);
        assert_int_equal(row.struct_size, sizeof row);
        meshes += row.format != 0;
    }
    assert_int_equal(meshes, CLEFT_FORMAT_PVTU);
    assert_int_equal(cleft_io_format_info(-1, &row), CLEFT_ERROR_ARGUMENT);
    assert_int_equal(cleft_io_format_info(cleft_io_format_count(), &row), CLEFT_ERROR_ARGUMENT);
    assert_int_equal(cleft_io_format_info(0, NULL), CLEFT_ERROR_NULL);
}

static void test_guess(void** state)
{
    fixture* f = *state;
    assert_int_equal(cleft_io_guess("a.nii.gz"), CLEFT_IO_VOLUME);
    assert_int_equal(cleft_io_guess("A.NRRD"), CLEFT_IO_VOLUME);
    assert_int_equal(cleft_io_guess("b/a.msh"), CLEFT_IO_MESH);
    assert_int_equal(cleft_io_guess("a.nii/b"), CLEFT_IO_UNKNOWN);
    assert_int_equal(cleft_io_guess(NULL), CLEFT_IO_UNKNOWN);
    assert_int_equal(cleft_io_guess(f->folder), CLEFT_IO_VOLUME);
    assert_int_equal(cleft_io_write_mesh(f->context, f->mesh, path_of(f, "a.vtk"), 0), CLEFT_OK);
    assert_int_equal(cleft_io_guess(f->path), CLEFT_IO_MESH);
    const char image[] = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\n";
    write_file(path_of(f, "b.vtk"), image, sizeof image - 1);
    assert_int_equal(cleft_io_guess(f->path), CLEFT_IO_VOLUME);
}

/* A full disk, as near as one can get: the system refuses to let files grow past `bytes`. */
static void limit_files(rlim_t bytes)
{
    struct rlimit limit;
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &limit), 0);
    limit.rlim_cur = bytes < limit.rlim_max ? bytes : limit.rlim_max;
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
}

static void test_failed_writing_keeps_the_old_file(void** state)
{
    fixture* f = *state;
    for (cleft_io_format format = CLEFT_FORMAT_VTU; format <= CLEFT_FORMAT_PLY; ++format) {
        char name[32];
        snprintf(name, sizeof name, "%d.%s", (int)format, format == CLEFT_FORMAT_TETGEN ? "node" : "old");
        write_file(path_of(f, name), "old", 3);
        const int64_t before = file_count(f);
        limit_files(1000);
        const cleft_status status = cleft_io_write_mesh(f->context, f->mesh, f->path, format);
        limit_files(RLIM_INFINITY);
        assert_refused(f, status, CLEFT_ERROR_FILE, strerror(EFBIG));
        assert_refused(f, status, CLEFT_ERROR_FILE, f->folder);
        size_t size = 0;
        char* kept = read_file(f->path, &size);
        assert_non_null(kept);
        assert_string_equal(kept, "old");
        free(kept);
        assert_int_equal(file_count(f), before);
    }
}

static void test_tetgen_is_three_files_or_none(void** state)
{
    fixture* f = *state;
    /* A folder in the place of the last file: the first two must not be left behind, nor the old one be lost. */
    write_file(path_of(f, "p.node"), "old", 3);
    mkdir(path_of(f, "p.face"), 0777);
    assert_refused(f, cleft_io_write_mesh(f->context, f->mesh, path_of(f, "p.ele"), CLEFT_FORMAT_TETGEN),
                   CLEFT_ERROR_FILE, "p.face");
    assert_int_equal(file_count(f), 2);
    size_t size = 0;
    char* kept = read_file(path_of(f, "p.node"), &size);
    assert_string_equal(kept, "old");
    free(kept);
}

/* In a folder like /tmp, where only the owner may replace a file: the last of three renamings fails. */
static void test_tetgen_takes_renamings_back(void** state)
{
    fixture* f = *state;
    if (geteuid() != 0)
        skip();
    write_file(path_of(f, "q.face"), "old", 3);
    assert_int_equal(chmod(f->folder, 01777), 0);
    const pid_t child = fork();
    if (child == 0) {
        if (setuid(65534) != 0)
            _exit(2);
        write_file(path_of(f, "q.node"), "mine", 4);
        _exit(cleft_io_write_mesh(f->context, f->mesh, f->path, CLEFT_FORMAT_TETGEN) == CLEFT_ERROR_FILE ? 0 : 1);
    }
    int status = -1;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(status, 0);
    size_t size = 0;
    char* kept = read_file(path_of(f, "q.node"), &size);
    assert_non_null(kept);
    assert_string_equal(kept, "mine");
    free(kept);
    assert_int_equal(file_count(f), 2);
}

static void test_places_that_cannot_be_written(void** state)
{
    fixture* f = *state;
    assert_refused(f, cleft_io_write_mesh(f->context, f->mesh, path_of(f, "none/a.vtu"), 0), CLEFT_ERROR_FILE,
                   strerror(ENOENT));
    mkdir(path_of(f, "folder.vtu"), 0777);
    assert_refused(f, cleft_io_write_mesh(f->context, f->mesh, f->path, 0), CLEFT_ERROR_FILE, "regular file");
    assert_refused(f, cleft_io_write_mesh(f->context, f->mesh, "/dev/full", CLEFT_FORMAT_VTU), CLEFT_ERROR_FILE,
                   "regular file");
    if (geteuid() != 0) { /* nothing is forbidden to root */
        mkdir(path_of(f, "locked"), 0555);
        assert_refused(f, cleft_io_write_mesh(f->context, f->mesh, path_of(f, "locked/a.vtu"), 0), CLEFT_ERROR_FILE,
                       strerror(EACCES));
    }
}

static void test_links_and_permissions_are_kept(void** state)
{
    fixture* f = *state;
    char link[128];
    struct stat status;
    write_file(path_of(f, "real.vtu"), "old", 3);
    assert_int_equal(chmod(f->path, 0640), 0);
    strcpy(link, path_of(f, "link.vtu"));
    assert_int_equal(symlink("real.vtu", link), 0);
    assert_int_equal(cleft_io_write_mesh(f->context, f->mesh, link, 0), CLEFT_OK);
    assert_int_equal(lstat(link, &status), 0);
    assert_true(S_ISLNK(status.st_mode));
    assert_int_equal(stat(path_of(f, "real.vtu"), &status), 0);
    assert_int_equal(status.st_mode & 0777, 0640);
    assert_true(status.st_size > 3);
    assert_int_equal(file_count(f), 2);
}

static void test_malformed_text_names_its_line(void** state)
{
    static const struct {
        const char* name;
        const char* text;
        cleft_status status;
        const char* words;
    } cases[] = {
        {"a.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n1\n0 0 zero 0\n", CLEFT_ERROR_FORMAT, "line 5"},
        {"a.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n1000000000\n", CLEFT_ERROR_FORMAT, "too short"},
        {"a.mesh", "MeshVersionFormatted 2\nDimension 2\n", CLEFT_ERROR_UNSUPPORTED, "three dimensions"},
        {"a.mesh", "MeshVersionFormatted 2\nHexahedra\n0\n", CLEFT_ERROR_UNSUPPORTED, "Hexahedra"},
        {"a.mesh", "MeshVersionFormatted 2\nTetrahedra\n1\n1 2 3 4 0\n", CLEFT_ERROR_FORMAT, "no point 1"},
        {"a.mesh", "MeshVersionFormatted 2\nVertices\n1\n0 0 1e999 0\n", CLEFT_ERROR_FORMAT, "not finite"},
        {"a.mesh", "", CLEFT_ERROR_FORMAT, "line 1"},
        {"a.msh", "$MeshFormat\n4.0 0 8\n", CLEFT_ERROR_UNSUPPORTED, "version 4.0"},
        {"a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", CLEFT_ERROR_FORMAT, "elements"},
        {"a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2\n1 0 0 0\n1 0 0 0\n$EndNodes\n", CLEFT_ERROR_FORMAT,
         "number of another"},
        {"a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Elements\n1\n1 5 0 1 2 3 4 5 6 7 8\n$EndElements\n",
         CLEFT_ERROR_UNSUPPORTED, "type 5"},
        {"a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Elements\n1\n1 4 0 1 2 3 4\n$EndElements\n",
         CLEFT_ERROR_FORMAT, "no point 1"},
        {"a.msh",
         "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 "
         "1\n$EndNodes\n$Elements\n1\n"
         "1 4 2 4294967297 1 1 2 3 4\n$EndElements\n",
         CLEFT_ERROR_FORMAT, "4294967297"},
        {"a.vtk", "# vtk DataFile Version 3.0\nx\nBINARY\n", CLEFT_ERROR_UNSUPPORTED, "binary"},
        {"a.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n", CLEFT_ERROR_UNSUPPORTED, "line 4"},
        {"a.vtk",
         "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 1 double\n0 0 0\nCELLS 1 5\n4 0 0 0 "
         "9\nCELL_TYPES 1\n10\n",
         CLEFT_ERROR_FORMAT, "point 9"},
        {"a.vtk",
         "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 1 double\n0 0 0\nCELLS 1 9\n8 0 0 0 "
         "0 0 0 0 0\nCELL_TYPES 1\n12\n",
         CLEFT_ERROR_UNSUPPORTED, "type 12"},
        {"a.vtu", "<VTKFile type=\"PolyData\">", CLEFT_ERROR_UNSUPPORTED, "UnstructuredGrid"},
        {"a.vtu", "not xml", CLEFT_ERROR_FORMAT, "no VTK file"},
        {"a.node", "1 3 0 0\n5 0 0 0\n", CLEFT_ERROR_FORMAT, "line 2"},
        {"a.node", "1 2 0 0\n", CLEFT_ERROR_UNSUPPORTED, "three dimensions"},
    };
    fixture* f = *state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        cleft_mesh* mesh = NULL;
        write_file(path_of(f, cases[i].name), cases[i].text, strlen(cases[i].text));
        assert_refused(f, cleft_io_read_mesh(f->context, f->path, &mesh), cases[i].status, cases[i].words);
        assert_refused(f, cases[i].status, cases[i].status, cases[i].name);
        assert_null(mesh);
    }
}

static uint32_t next_random(uint32_t* state)
{
    *state = *state * 1664525u + 1013904223u;
    return *state >> 8;
}

/* Reads what is in the file: it must be a mesh or an error with a sentence. */
static void read_anything(fixture* f)
{
    cleft_mesh* mesh = NULL;
    const cleft_status status = cleft_io_read_mesh(f->context, f->path, &mesh);
    assert_true((status == CLEFT_OK) == (mesh != NULL));
    assert_true(status == CLEFT_OK || cleft_context_last_error(f->context)[0] != '\0');
    assert_int_not_equal(status, CLEFT_ERROR_INTERNAL);
    cleft_mesh_destroy(mesh);
}

static void test_damaged_files_never_crash(void** state)
{
    enum { CUTS = 150, MUTATIONS = 600 };
    fixture* f = *state;
    uint32_t seed = 1;
    for (int i = 0; i < READABLE + 1; ++i) {
        const int binary = i == READABLE; /* version 4.1 */
        const char* path = path_of(f, binary ? "b.msh" : readable[i]);
        const cleft_io_format format = strstr(path, "a.msh") ? CLEFT_FORMAT_MSH22 : CLEFT_FORMAT_BY_NAME;
        assert_int_equal(cleft_io_write_mesh(f->context, f->mesh, path, format), CLEFT_OK);
        size_t size = 0;
        char* whole = read_file(path, &size);
        assert_non_null(whole);
        char* damaged = malloc(size);
        for (int c = 0; c < CUTS; ++c) {
            write_file(path, whole, size * (size_t)c / CUTS);
            read_anything(f);
        }
        for (int m = 0; m < MUTATIONS; ++m) {
            memcpy(damaged, whole, size);
            /* Half of the damage near the front, where the headers are. */
            for (int hit = 0; hit <= m % 4; ++hit)
                damaged[next_random(&seed) % (m % 2 && size > 1000 ? 1000 : size)] =
                    m % 3 == 0 ? (char)('0' + next_random(&seed) % 10) : (char)next_random(&seed);
            write_file(path, damaged, size);
            read_anything(f);
        }
        free(damaged);
        free(whole);
    }
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_round_trip_keeps_every_bit),
        TEST(test_same_bytes_for_any_number_of_threads),
        TEST(test_wrong_arguments),
        TEST(test_table_of_formats),
        TEST(test_guess),
        TEST(test_failed_writing_keeps_the_old_file),
        TEST(test_tetgen_is_three_files_or_none),
        TEST(test_tetgen_takes_renamings_back),
        TEST(test_places_that_cannot_be_written),
        TEST(test_links_and_permissions_are_kept),
        TEST(test_malformed_text_names_its_line),
        TEST(test_damaged_files_never_crash),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
