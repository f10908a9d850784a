/* The table of options says which calls read each option. Here this is tried: an option that a call reads changes what
 * it makes, with at least one setting of the others; one that it does not read never does. */
#include "support/capi.h"

#include <math.h>
#include <string.h>

enum { N = 12, MOST_TEXTS = 5 };

/* Other options, as name and value in turn. Where it can be, improving is off, which saves most of the time. */
static const char* const kSettings[][2 * MOST_TEXTS] = {
    {"improve", "off", NULL},
    {"improve", "off", "tets", "2000", NULL},
    {"improve", "off", "tets", "1000", "snap", "none", NULL},
    {"improve", "fast", "tets", "2000", NULL},
    {"improve", "off", "background", "lattice", NULL},
    {"improve", "off", "background", "lattice", "max_tets", "1500", NULL},
    {"improve", "off", "background", "lattice", "size", "2", NULL},
};
enum { SETTINGS = sizeof kSettings / sizeof *kSettings };

/* For each option a value that makes a difference where it is read. */
static const char* const kValues[][2] = {
    {"background", "octree"},  {"size", "3"},          {"size_min", "1.5"},
    {"size_max", "1.5"},       {"feature_scale", "3"}, {"gradation", "0.05"},
    {"interface_size", "1"},   {"keep_thin", "true"},  {"tets", "3000"},
    {"max_tets", "1000"},      {"smooth", "2"},        {"snap", "none"},
    {"improve", "fast"},       {"steps", "1"},         {"seed", "7"},
    {"strict", "true"},        {"repair", "0"},        {"min_angle", "30"},
    {"surface_error", "0.02"}, {"anisotropy", "3"},    {"block", "6"},
};
/* Those whose values make no difference by design. */
static const char* const kSameMesh[] = {"delaunay"};
enum { VALUES = sizeof kValues / sizeof *kValues };

typedef struct {
    cleft_context* context;
    cleft_volume* volume;
    cleft_sizing* sizing;
    cleft_mesh* background; /* with poor tetrahedra */
    cleft_mesh* cleaved;
    cleft_mesh* broken; /* cleaved, too, but so coarse that the sheet is in pieces */
} world;

static uint64_t mixed(uint64_t hash, const void* bytes, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        hash = (hash ^ ((const unsigned char*)bytes)[i]) * 1099511628211u;
    return hash;
}

static uint64_t mesh_hash(cleft_mesh* mesh, cleft_status status)
{
    uint64_t hash = mixed(14695981039346656037u, &status, sizeof status);
    const size_t points = (size_t)cleft_mesh_point_count(mesh), tets = (size_t)cleft_mesh_tet_count(mesh);
    hash = mixed(hash, cleft_mesh_points(mesh), points * 3 * sizeof(double));
    hash = mixed(hash, cleft_mesh_tets(mesh), tets * 4 * sizeof(int32_t));
    cleft_mesh_destroy(mesh);
    return hash;
}

/* A leaning sheet, one voxel thick, that breaks in a coarse mesh. */
static uint64_t make_volume(world* w, const cleft_options* options, cleft_volume** out)
{
    static uint8_t voxels[N * N * N];
    double points[3 * N * N * N];
    int32_t labels[N * N * N];
    const int64_t dims[3] = {N, N, N};
    for (int v = 0; v < N * N * N; ++v) {
        const int x = v % N, y = v / N % N, z = v / N / N;
        voxels[v] = 3 * z - x - y >= 12 && 3 * z - x - y < 15;
    }
    assert_ok(w->context, cleft_volume_create_labels(w->context, CLEFT_TYPE_UINT8, voxels, dims, NULL, options, out));
    for (int i = 0; i < N * N * N; ++i) {
        points[3 * i] = i % N + 0.93;
        points[3 * i + 1] = i / N % N + 0.93;
        points[3 * i + 2] = i / N / N + 0.93;
    }
    assert_int_equal(cleft_volume_sample(*out, points, N * N * N, labels), CLEFT_OK);
    return mixed(0, labels, sizeof labels);
}

static uint64_t volume_call(world* w, const cleft_options* options)
{
    cleft_volume* volume = NULL;
    const uint64_t hash = make_volume(w, options, &volume);
    cleft_volume_destroy(volume);
    return hash;
}

static uint64_t sizing_call(world* w, const cleft_options* options)
{
    cleft_sizing* sizing = NULL;
    assert_ok(w->context, cleft_sizing_create(w->context, w->volume, options, &sizing));
    const uint64_t hash = mixed(0, cleft_sizing_values(sizing), sizeof(float) * N * N * N);
    cleft_sizing_destroy(sizing);
    return hash;
}

static uint64_t background_call(world* w, const cleft_options* options)
{
    cleft_mesh* mesh = NULL;
    const cleft_status status = cleft_background_create(w->context, w->sizing, options, &mesh);
    return mesh_hash(mesh, status);
}

static uint64_t cleave_call(world* w, const cleft_options* options)
{
    cleft_mesh* mesh = NULL;
    const cleft_status status = cleft_mesh_cleave(w->context, w->volume, w->background, options, &mesh);
    return mesh_hash(mesh, status);
}

static uint64_t improve_call(world* w, const cleft_options* options)
{
    uint64_t hash = 0;
    for (int i = 0; i < 2; ++i) {
        cleft_mesh* mesh = NULL;
        const cleft_status status =
            cleft_mesh_improve(w->context, w->volume, i == 0 ? w->cleaved : w->broken, options, &mesh);
        hash = 31 * hash + mesh_hash(mesh, status);
    }
    return hash;
}

/* With the stages' own backgrounds, and with one that is given. */
static uint64_t mesh_call(world* w, const cleft_options* options)
{
    cleft_mesh* mesh = NULL;
    cleft_status status = cleft_mesh_volume(w->context, w->volume, NULL, NULL, options, &mesh);
    const uint64_t own = mesh_hash(mesh, status);
    mesh = NULL;
    status = cleft_mesh_volume(w->context, w->volume, NULL, w->background, options, &mesh);
    const uint64_t given = mesh_hash(mesh, status);
    return own * 31 + given;
}

static const struct {
    const char* name;
    uint64_t (*run)(world*, const cleft_options*);
    int settings; /* how many of kSettings are tried: others tell the kind of background apart */
} kCalls[] = {{"volume", volume_call, 1}, {"sizing", sizing_call, 4},   {"background", background_call, SETTINGS},
              {"cleave", cleave_call, 1}, {"improve", improve_call, 4}, {"mesh", mesh_call, SETTINGS}};
enum { CALLS = sizeof kCalls / sizeof *kCalls };

static cleft_options* options_of(const char* const* texts)
{
    cleft_options* options = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    for (; *texts; texts += 2)
        assert_int_equal(cleft_options_set_text(options, texts[0], texts[1]), CLEFT_OK);
    return options;
}

/* A lattice whose inner points were moved, so that some of its tetrahedra are poor. */
static cleft_mesh* poor_background(world* w)
{
    static const char* const lattice[] = {"background", "lattice", NULL};
    cleft_options* options = options_of(lattice);
    cleft_mesh *mesh = NULL, *moved = NULL;
    assert_ok(w->context, cleft_background_create(w->context, w->sizing, options, &mesh));
    const int64_t count = cleft_mesh_point_count(mesh);
    double* points = (double*)malloc((size_t)count * 3 * sizeof(double));
    assert_int_equal(cleft_mesh_copy_points(mesh, points, 3 * count), CLEFT_OK);
    const double edge = fabs(points[3 * cleft_mesh_tets(mesh)[0]] - points[3 * cleft_mesh_tets(mesh)[1]]) +
                        fabs(points[3 * cleft_mesh_tets(mesh)[0] + 1] - points[3 * cleft_mesh_tets(mesh)[1] + 1]);
    uint32_t state = 1;
    for (int64_t i = 0; i < 3 * count; ++i) {
        state = state * 1664525u + 1013904223u;
        if (points[i] > 0.1 * edge && points[i] < N - 0.1 * edge)
            points[i] += 0.22 * edge * (state / 2147483648.0 - 1);
    }
    assert_ok(w->context, cleft_mesh_create(w->context, count, points, cleft_mesh_tet_count(mesh),
                                            cleft_mesh_tets(mesh), NULL, 0, &moved));
    free(points);
    cleft_mesh_destroy(mesh);
    cleft_options_destroy(options);
    return moved;
}

static cleft_mesh* broken_mesh(world* w)
{
    static const char* const lattice[] = {"background", "lattice", NULL};
    cleft_options* options = options_of(lattice);
    cleft_sizing* sizing = NULL;
    cleft_mesh *background = NULL, *cleaved = NULL;
    assert_ok(w->context, cleft_sizing_create_constant(w->context, w->volume, 3, &sizing));
    assert_ok(w->context, cleft_background_create(w->context, sizing, options, &background));
    assert_ok(w->context, cleft_mesh_cleave(w->context, w->volume, background, NULL, &cleaved));
    cleft_mesh_destroy(background);
    cleft_sizing_destroy(sizing);
    cleft_options_destroy(options);
    return cleaved;
}

static void make_world(world* w)
{
    w->context = new_context();
    make_volume(w, NULL, &w->volume);
    assert_ok(w->context, cleft_sizing_create(w->context, w->volume, NULL, &w->sizing));
    w->background = poor_background(w);
    assert_ok(w->context, cleft_mesh_cleave(w->context, w->volume, w->background, NULL, &w->cleaved));
    w->broken = broken_mesh(w);
}

static void destroy_world(world* w)
{
    cleft_mesh_destroy(w->broken);
    cleft_mesh_destroy(w->cleaved);
    cleft_mesh_destroy(w->background);
    cleft_sizing_destroy(w->sizing);
    cleft_volume_destroy(w->volume);
    cleft_context_destroy(w->context);
}

static const char* value_for(const char* name)
{
    for (int i = 0; i < VALUES; ++i)
        if (!strcmp(kValues[i][0], name))
            return kValues[i][1];
    fail_msg("%s has no value here: add one", name);
    return "";
}

static int gives_the_same_mesh(const char* name)
{
    for (size_t i = 0; i < sizeof kSameMesh / sizeof *kSameMesh; ++i)
        if (!strcmp(kSameMesh[i], name))
            return 1;
    return 0;
}

static int names_call(const char* calls, const char* name)
{
    const size_t length = strlen(name);
    for (const char* at = strstr(calls, name); at; at = strstr(at + 1, name))
        if ((at == calls || at[-1] == '|') && (at[length] == '|' || at[length] == '\0'))
            return 1;
    return 0;
}

static void the_calls_of_the_table_are_those_that_read(void** state)
{
    world w;
    uint64_t without[CALLS][SETTINGS];
    (void)state;
    make_world(&w);
    for (int s = 0; s < SETTINGS; ++s) {
        cleft_options* options = options_of(kSettings[s]);
        for (int c = 0; c < CALLS; ++c)
            without[c][s] = s < kCalls[c].settings ? kCalls[c].run(&w, options) : 0;
        cleft_options_destroy(options);
    }
    for (int32_t i = 0; i < cleft_option_count(); ++i) {
        cleft_option_description row = {.struct_size = sizeof row};
        int is_read[CALLS] = {0};
        assert_int_equal(cleft_option_info(i, &row), CLEFT_OK);
        if (gives_the_same_mesh(row.name))
            continue;
        for (int s = 0; s < SETTINGS; ++s) {
            cleft_options* options = options_of(kSettings[s]);
            assert_int_equal(cleft_options_set_text(options, row.name, value_for(row.name)), CLEFT_OK);
            for (int c = 0; c < CALLS; ++c)
                if (s < kCalls[c].settings && !is_read[c] && kCalls[c].run(&w, options) != without[c][s])
                    is_read[c] = 1;
            cleft_options_destroy(options);
        }
        for (int c = 0; c < CALLS; ++c)
            if (is_read[c] != names_call(row.calls, kCalls[c].name))
                fail_msg("%s %s %s, which is not what the table says (%s)", kCalls[c].name,
                         is_read[c] ? "reads" : "does not read", row.name, row.calls);
    }
    destroy_world(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_calls_of_the_table_are_those_that_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
