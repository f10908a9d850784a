/* Labels are names: whatever numbers a user takes, the mesh is the same up to them. */
#include "support/capi.h"

#include <string.h>

enum { MAX_LABELS = 5 };

/* Numbers that programs like to keep for themselves, ascending. */
static const int32_t kAwkward[] = {
    INT32_MIN, INT32_MIN + 1, -65536, -32768, -256,     -128,          -3,       -2, -1, 0, 1, 2, 127, 255,
    256,       32767,         65535,  65536,  16777217, INT32_MAX - 1, INT32_MAX};
enum { AWKWARD = sizeof kAwkward / sizeof *kAwkward };

static uint32_t next_random(uint32_t* state)
{
    *state = *state * 1664525U + 1013904223U;
    return *state >> 8;
}

static int by_value(const void* a, const void* b)
{
    const int32_t x = *(const int32_t*)a, y = *(const int32_t*)b;
    return (x > y) - (x < y);
}

/* `count` different labels, ascending: from the awkward ones, or from the whole range. */
static void random_labels(uint32_t* state, int count, int32_t* labels)
{
    for (int i = 0; i < count; ++i) {
        const int awkward = next_random(state) % 4 != 0;
        const uint32_t any = next_random(state) << 16 ^ next_random(state);
        labels[i] = awkward ? kAwkward[next_random(state) % AWKWARD] : (int32_t)any;
        for (int j = 0; j < i; ++j)
            if (labels[j] == labels[i])
                --i, j = i; /* once more */
    }
    qsort(labels, (size_t)count, sizeof *labels, by_value);
}

/* Balls of several materials in material 0, by number 0 .. count - 1. */
static void random_materials(uint32_t* state, int n, int count, int32_t* materials)
{
    memset(materials, 0, sizeof *materials * (size_t)(n * n * n));
    for (int ball = 0; ball < 4 + count; ++ball) {
        const int c[3] = {(int)(next_random(state) % (uint32_t)n), (int)(next_random(state) % (uint32_t)n),
                          (int)(next_random(state) % (uint32_t)n)};
        const int r = 2 + (int)(next_random(state) % 2), material = ball % count;
        for (int k = 0; k < n; ++k)
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) {
                    const int x = i - c[0], y = j - c[1], z = k - c[2];
                    if (x * x + y * y + z * z <= r * r)
                        materials[i + n * (j + n * k)] = material;
                }
    }
    for (int m = 0; m < count; ++m) /* none is hidden by the others */
        materials[m] = m;
}

typedef struct result {
    cleft_context* context;
    cleft_volume* volume;
    cleft_mesh* mesh;
    cleft_surface* surface;
    cleft_report* report;
    cleft_validation validation;
} result;

static result mesh_of(int n, const int32_t* materials, const int32_t* labels)
{
    result r = {.context = new_context(), .validation = {.struct_size = sizeof(cleft_validation)}};
    const int64_t dims[3] = {n, n, n};
    int32_t* voxels = (int32_t*)malloc(sizeof *voxels * (size_t)(n * n * n));
    cleft_options* options = NULL;
    for (int v = 0; v < n * n * n; ++v)
        voxels[v] = labels[materials[v]];
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_BACKGROUND, CLEFT_BACKGROUND_LATTICE), CLEFT_OK);
    assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SIZE_MIN, 1.2), CLEFT_OK);
    assert_ok(r.context, cleft_volume_create_labels(r.context, CLEFT_TYPE_INT32, voxels, dims, NULL, NULL, &r.volume));
    assert_ok(r.context, cleft_mesh_volume(r.context, r.volume, NULL, NULL, options, &r.mesh));
    assert_ok(r.context, cleft_surface_create(r.context, r.mesh, &r.surface));
    assert_ok(r.context, cleft_report_create(r.context, r.volume, r.mesh, &r.report));
    assert_ok(r.context, cleft_mesh_validate(r.context, r.mesh, 1, &r.validation));
    assert_int_equal(r.validation.valid, 1);
    cleft_options_destroy(options);
    free(voxels);
    return r;
}

static void release(result* r)
{
    cleft_report_destroy(r->report);
    cleft_surface_destroy(r->surface);
    cleft_mesh_destroy(r->mesh);
    cleft_volume_destroy(r->volume);
    cleft_context_destroy(r->context);
}

/* The surface has as many triangles as there are faces of the kind, which validation counts by itself. */
static void assert_whole_surface(const result* r)
{
    assert_true(r->validation.interface_triangles > 0 && r->validation.hull_triangles > 0);
    assert_int_equal(cleft_surface_interface_count(r->surface), r->validation.interface_triangles);
    assert_int_equal(cleft_surface_hull_count(r->surface), r->validation.hull_triangles);
}

static int place(const int32_t* labels, int count, int32_t label)
{
    for (int i = 0; i < count; ++i)
        if (labels[i] == label)
            return i;
    fail_msg("label %d is none of the volume's", (int)label);
    return -1;
}

static void assert_same_labels(const int32_t* a, const int32_t* in_a, const int32_t* b, const int32_t* in_b,
                               int64_t length, int count)
{
    for (int64_t i = 0; i < length; ++i)
        assert_int_equal(place(in_a, count, a[i]), place(in_b, count, b[i]));
}

static void assert_same_surface(const result* a, const int32_t* in_a, const result* b, const int32_t* in_b, int count)
{
    const int64_t interfaces = cleft_surface_interface_count(a->surface), hull = cleft_surface_hull_count(a->surface);
    assert_int_equal(cleft_surface_interface_count(b->surface), interfaces);
    assert_memory_equal(cleft_surface_interface_triangles(a->surface), cleft_surface_interface_triangles(b->surface),
                        sizeof(int32_t) * 3 * (size_t)interfaces);
    assert_same_labels(cleft_surface_interface_labels(a->surface), in_a, cleft_surface_interface_labels(b->surface),
                       in_b, 2 * interfaces, count);
    assert_int_equal(cleft_surface_hull_count(b->surface), hull);
    assert_memory_equal(cleft_surface_hull_triangles(a->surface), cleft_surface_hull_triangles(b->surface),
                        sizeof(int32_t) * 3 * (size_t)hull);
    assert_memory_equal(cleft_surface_hull_sides(a->surface), cleft_surface_hull_sides(b->surface),
                        sizeof(int32_t) * (size_t)hull);
    assert_same_labels(cleft_surface_hull_labels(a->surface), in_a, cleft_surface_hull_labels(b->surface), in_b, hull,
                       count);
}

static void assert_same_reports(const result* a, const int32_t* in_a, const result* b, const int32_t* in_b, int count)
{
    assert_int_equal(cleft_report_count(a->report), count);
    assert_int_equal(cleft_report_count(b->report), count);
    for (int i = 0; i < count; ++i) {
        cleft_label_report p = {.struct_size = sizeof p}, q = {.struct_size = sizeof q};
        assert_int_equal(cleft_report_label(a->report, i, &p), CLEFT_OK);
        assert_int_equal(p.label, in_a[i]);
        for (int row = 0; row < count && (row == 0 || q.label != in_b[i]); ++row)
            assert_int_equal(cleft_report_label(b->report, row, &q), CLEFT_OK);
        assert_int_equal(q.label, in_b[i]);
        q.label = p.label;
        assert_memory_equal(&p, &q, sizeof p);
    }
}

static int is_ascending(const int32_t* labels, int count)
{
    for (int i = 1; i < count; ++i)
        if (labels[i] < labels[i - 1])
            return 0;
    return 1;
}

/* The same mesh in every bit, but for the names of its labels. */
static void assert_same(const result* a, const int32_t* in_a, const result* b, const int32_t* in_b, int count)
{
    const int64_t points = cleft_mesh_point_count(a->mesh), tets = cleft_mesh_tet_count(a->mesh);
    assert_int_equal(cleft_mesh_point_count(b->mesh), points);
    assert_int_equal(cleft_mesh_tet_count(b->mesh), tets);
    assert_memory_equal(cleft_mesh_points(a->mesh), cleft_mesh_points(b->mesh), sizeof(double) * 3 * (size_t)points);
    assert_memory_equal(cleft_mesh_tets(a->mesh), cleft_mesh_tets(b->mesh), sizeof(int32_t) * 4 * (size_t)tets);
    assert_same_labels(cleft_mesh_tet_labels(a->mesh), in_a, cleft_mesh_tet_labels(b->mesh), in_b, tets, count);
    assert_memory_equal(&a->validation, &b->validation, sizeof a->validation);
    if (is_ascending(in_b, count)) /* of two labels, the lesser one decides which way an interface looks */
        assert_same_surface(a, in_a, b, in_b, count);
    assert_int_equal(cleft_surface_interface_count(b->surface), cleft_surface_interface_count(a->surface));
    assert_int_equal(cleft_surface_hull_count(b->surface), cleft_surface_hull_count(a->surface));
    assert_same_reports(a, in_a, b, in_b, count);
}

/* Names in any order: materials that tie must not look at them. */
static void shuffle(uint32_t* random, int count, int32_t* labels)
{
    for (int i = count - 1; i > 0; --i) {
        const int other = (int)(next_random(random) % (uint32_t)(i + 1));
        const int32_t label = labels[i];
        labels[i] = labels[other];
        labels[other] = label;
    }
}

static void other_names_change_nothing_else(void** state)
{
    static const int32_t numbers[MAX_LABELS] = {0, 1, 2, 3, 4};
    enum { N = 9 };
    int32_t materials[N * N * N], labels[MAX_LABELS];
    uint32_t random = 20;
    (void)state;
    for (int count = 2; count <= MAX_LABELS; ++count) {
        random_materials(&random, N, count, materials);
        result plain = mesh_of(N, materials, numbers);
        assert_whole_surface(&plain);
        for (int round = 0; round < 6; ++round) {
            random_labels(&random, count, labels);
            if (round > 1)
                shuffle(&random, count, labels);
            result named = mesh_of(N, materials, labels);
            assert_whole_surface(&named);
            assert_same(&plain, numbers, &named, labels, count);
            release(&named);
        }
        release(&plain);
    }
}

static void half_and_half_meet_in_the_same_triangles_under_any_name(void** state)
{
    enum { N = 8 };
    int32_t materials[N * N * N];
    int64_t triangles = 0;
    (void)state;
    for (int v = 0; v < N * N * N; ++v)
        materials[v] = v % N >= N / 2;
    for (int i = 0; i < AWKWARD; ++i) {
        if (kAwkward[i] == 2)
            continue;
        const int32_t labels[2] = {kAwkward[i], 2};
        result r = mesh_of(N, materials, labels);
        assert_whole_surface(&r);
        if (i == 0)
            triangles = cleft_surface_interface_count(r.surface);
        assert_int_equal(cleft_surface_interface_count(r.surface), triangles);
        release(&r);
    }
}

static void a_mesh_of_arrays_keeps_its_surface_under_any_name(void** state)
{
    static const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
    static const int32_t tets[] = {0, 1, 2, 3, 1, 2, 3, 4};
    cleft_context* context = new_context();
    (void)state;
    for (int i = 0; i < AWKWARD; ++i)
        for (int j = 0; j < AWKWARD; ++j) {
            const int32_t labels[2] = {kAwkward[i], kAwkward[j]};
            cleft_validation found = {.struct_size = sizeof found};
            cleft_mesh* mesh = NULL;
            cleft_surface* surface = NULL;
            assert_ok(context, cleft_mesh_create(context, 5, points, 2, tets, labels, 0, &mesh));
            assert_ok(context, cleft_surface_create(context, mesh, &surface));
            assert_ok(context, cleft_mesh_validate(context, mesh, 0, &found));
            assert_int_equal(cleft_surface_interface_count(surface), i != j);
            assert_int_equal(found.interface_triangles, i != j);
            assert_int_equal(cleft_surface_hull_count(surface), 6);
            assert_int_equal(found.hull_triangles, 6);
            if (i != j)
                assert_int_equal(cleft_surface_interface_labels(surface)[0], kAwkward[i < j ? i : j]);
            cleft_surface_destroy(surface);
            cleft_mesh_destroy(mesh);
        }
    cleft_context_destroy(context);
}

static void labels_beyond_32_bits_with_a_sign_are_refused(void** state)
{
    const int64_t dims[3] = {2, 1, 1};
    const uint32_t greatest[2] = {0, INT32_MAX}, beyond[2] = {1, (uint32_t)INT32_MAX + 1}, all[2] = {UINT32_MAX, 3};
    cleft_context* context = new_context();
    cleft_volume* volume = NULL;
    (void)state;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_UINT32, greatest, dims, NULL, NULL, &volume));
    assert_int_equal(cleft_volume_labels(volume)[1], INT32_MAX);
    cleft_volume_destroy(volume);
    assert_fails(context, CLEFT_ERROR_ARGUMENT,
                 cleft_volume_create_labels(context, CLEFT_TYPE_UINT32, beyond, dims, NULL, NULL, &volume));
    assert_non_null(strstr(cleft_context_last_error(context), "2147483648"));
    assert_null(volume);
    assert_fails(context, CLEFT_ERROR_ARGUMENT,
                 cleft_volume_create_labels(context, CLEFT_TYPE_UINT32, all, dims, NULL, NULL, &volume));
    assert_non_null(strstr(cleft_context_last_error(context), "4294967295"));
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(other_names_change_nothing_else),
        cmocka_unit_test(half_and_half_meet_in_the_same_triangles_under_any_name),
        cmocka_unit_test(a_mesh_of_arrays_keeps_its_surface_under_any_name),
        cmocka_unit_test(labels_beyond_32_bits_with_a_sign_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
