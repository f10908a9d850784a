/* What the report says, against the same found by other means: contacts that the voxels do not have. */
#include "support/capi.h"

#include <stdbool.h>
#include <string.h>

enum { N = 24, MOST_PAIRS = 400 };

typedef struct {
    int32_t first, second;
    int64_t triangles;
} pair;

/* A ball in a socket, a gap of about a voxel between them that opens to the outside; what the three are called. Beside
 * a wide gap the two touch nowhere, beside the other at corners of voxels. */
static int32_t* socket_labels(int32_t outside, int32_t ball, int32_t socket, bool is_wide)
{
    int32_t* labels = (int32_t*)malloc(sizeof(int32_t) * N * N * N);
    for (int k = 0; k < N; ++k)
        for (int j = 0; j < N; ++j)
            for (int i = 0; i < N; ++i) {
                const double x = i + 0.5 - N / 2.0, y = j + 0.5 - N / 2.0, z = k + 0.5 - N / 2.0;
                const double square = x * x + y * y + z * z;
                const double inner = is_wide ? 6 : 6.2, outer = is_wide ? 7.6 : 7.4;
                const bool in_socket = square > outer * outer && square < 10.5 * 10.5 && z < 2;
                labels[i + N * (j + N * k)] = square < inner * inner ? ball : in_socket ? socket : outside;
            }
    return labels;
}

/* Voxels of `count` labels at random. */
static int32_t* noise_labels(int count)
{
    int32_t* labels = (int32_t*)malloc(sizeof(int32_t) * N * N * N);
    uint32_t state = 1;
    for (int v = 0; v < N * N * N; ++v) {
        state = state * 1664525u + 1013904223u;
        /* blocks of 3 voxels, so that labels are larger than tetrahedra */
        const int block = v % N / 6 + 4 * (v / N % N / 6) + 16 * (v / N / N / 6);
        labels[v] = (block * 7 + (state >> 28 == 0 ? 1 : 0)) % count - count / 2;
    }
    return labels;
}

static cleft_volume* volume_of(cleft_context* context, const int32_t* labels)
{
    const int64_t dims[3] = {N, N, N};
    cleft_volume* volume = NULL;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_INT32, labels, dims, NULL, NULL, &volume));
    return volume;
}

static bool voxels_touch(const int32_t* labels, int32_t first, int32_t second)
{
    for (int v = 0; v < N * N * N; ++v) {
        if (labels[v] != first)
            continue;
        const int x = v % N, y = v / N % N, z = v / N / N;
        for (int k = z > 0 ? z - 1 : 0; k <= z + 1 && k < N; ++k)
            for (int j = y > 0 ? y - 1 : 0; j <= y + 1 && j < N; ++j)
                for (int i = x > 0 ? x - 1 : 0; i <= x + 1 && i < N; ++i)
                    if ((i == x || j == y || k == z) && labels[i + N * (j + N * k)] == second)
                        return true;
    }
    return false;
}

/* The pairs that share triangles in the mesh and do not touch in the voxels, from the surface of the mesh. */
static int expected_contacts(cleft_context* context, const cleft_mesh* mesh, const int32_t* labels, pair* out)
{
    int count = 0;
    cleft_surface* surface = NULL;
    assert_ok(context, cleft_surface_create(context, mesh, &surface));
    const int32_t* both = cleft_surface_interface_labels(surface);
    for (int64_t t = 0; t < cleft_surface_interface_count(surface); ++t) {
        const int32_t first = both[2 * t], second = both[2 * t + 1];
        const bool same = count > 0 && out[count - 1].first == first && out[count - 1].second == second;
        if (same) {
            ++out[count - 1].triangles;
        } else if (!voxels_touch(labels, first, second)) {
            assert_true(count < MOST_PAIRS);
            out[count++] = (pair){first, second, 1};
        }
    }
    cleft_surface_destroy(surface);
    return count;
}

static void assert_contacts(cleft_context* context, const cleft_volume* volume, const cleft_mesh* mesh,
                            const int32_t* labels, bool are_some)
{
    static pair expected[MOST_PAIRS];
    cleft_report* report = NULL;
    cleft_contact contact = {.struct_size = sizeof contact};
    const int count = expected_contacts(context, mesh, labels, expected);
    assert_ok(context, cleft_report_create(context, volume, mesh, &report));
    assert_int_equal(cleft_report_contact_count(report), count);
    assert_int_equal(count > 0, are_some);
    for (int i = 0; i < count; ++i) {
        assert_ok(context, cleft_report_contact(report, i, &contact));
        assert_int_equal(contact.first, expected[i].first);
        assert_int_equal(contact.second, expected[i].second);
        assert_int_equal(contact.triangles, expected[i].triangles);
    }
    assert_int_equal(cleft_report_contact(report, count, &contact), CLEFT_ERROR_ARGUMENT);
    assert_int_equal(cleft_report_contact(report, -1, &contact), CLEFT_ERROR_ARGUMENT);
    contact.struct_size = 0;
    assert_int_equal(cleft_report_contact(report, 0, &contact), CLEFT_ERROR_ARGUMENT);
    cleft_report_destroy(report);
}

static cleft_options* of_size(double size)
{
    cleft_options* options = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    if (size > 0)
        assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SIZE, size), CLEFT_OK);
    return options;
}

static void assert_contacts_at(const int32_t* labels, double size, bool are_some)
{
    cleft_context* context = new_context();
    cleft_volume* volume = volume_of(context, labels);
    cleft_options* options = of_size(size);
    cleft_mesh* mesh = NULL;
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    assert_contacts(context, volume, mesh, labels, are_some);
    cleft_mesh_destroy(mesh);
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void contacts_that_the_voxels_do_not_have_are_named(void** state)
{
    static const int32_t names[4][3] = {{0, 1, 2}, {5, -1, -2}, {-1, INT32_MIN, INT32_MAX}, {7, 0, -1}};
    (void)state;
    for (int i = 0; i < 4; ++i) {
        int32_t* labels = socket_labels(names[i][0], names[i][1], names[i][2], i % 2 == 0);
        assert_contacts_at(labels, 4, true);
        assert_contacts_at(labels, 0, false);
        free(labels);
    }
}

static void contacts_among_many_labels_are_those_of_the_surface(void** state)
{
    (void)state;
    int32_t* labels = noise_labels(40);
    assert_contacts_at(labels, 5, true);
    free(labels);
}

static void contacts_of_functions_are_those_of_the_winners(void** state)
{
    static const int32_t names[3] = {9, 4, -1};
    const int64_t dims[3] = {N, N, N};
    cleft_context* context = new_context();
    int32_t* labels = socket_labels(9, 4, -1, false);
    float* field[3] = {NULL, NULL, NULL};
    cleft_volume* volume = NULL;
    cleft_options* options = of_size(3.5);
    cleft_mesh* mesh = NULL;
    (void)state;
    for (int f = 0; f < 3; ++f) {
        field[f] = (float*)malloc(sizeof(float) * N * N * N);
        for (int v = 0; v < N * N * N; ++v)
            field[f][v] = labels[v] == names[f] ? 0.9f : 0.05f;
    }
    assert_ok(context, cleft_volume_create_indicators(context, CLEFT_TYPE_FLOAT32, (const void* const*)field, 3, dims,
                                                      NULL, names, &volume));
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    assert_contacts(context, volume, mesh, labels, true);
    for (int f = 0; f < 3; ++f)
        free(field[f]);
    free(labels);
    cleft_mesh_destroy(mesh);
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void strict_fails_for_a_new_contact_of_kept_labels(void** state)
{
    const int32_t left_out[2] = {0, 1};
    cleft_context* context = new_context();
    int32_t* labels = socket_labels(0, 1, 2, false);
    cleft_volume* volume = volume_of(context, labels);
    cleft_options* options = of_size(3.5);
    cleft_mesh* mesh = NULL;
    (void)state;
    assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_STRICT, 1), CLEFT_OK);
    assert_fails(context, CLEFT_ERROR_LABEL_LOST, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    assert_null(mesh);
    /* label 0 broke in the gap; without it, the contact is what is left */
    assert_int_equal(cleft_options_set_strip(options, left_out, 1), CLEFT_OK);
    assert_fails(context, CLEFT_ERROR_LABEL_LOST, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    assert_non_null(strstr(cleft_context_last_error(context), "label 1 and label 2 share"));
    assert_int_equal(cleft_options_set_strip(options, left_out, 2), CLEFT_OK);
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    free(labels);
    cleft_mesh_destroy(mesh);
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contacts_that_the_voxels_do_not_have_are_named),
        cmocka_unit_test(contacts_among_many_labels_are_those_of_the_surface),
        cmocka_unit_test(contacts_of_functions_are_those_of_the_winners),
        cmocka_unit_test(strict_fails_for_a_new_contact_of_kept_labels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
