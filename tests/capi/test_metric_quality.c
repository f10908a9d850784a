/* Measures of a mesh by a metric, computed anew. */
#include "support/capi.h"

#include <math.h>
#include <string.h>

enum { N = 24, kVoxels = N * N * N };

static int compare_keys(const void* a, const void* b)
{
    const int64_t x = *(const int64_t*)a, y = *(const int64_t*)b;
    return (x > y) - (x < y);
}

static int compare_reals(const void* a, const void* b)
{
    const double x = *(const double*)a, y = *(const double*)b;
    return (x > y) - (x < y);
}

static const int kEnds[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

/* The edges, each once: their ends, the lower number first. */
static int64_t edges_of(const cleft_mesh* mesh, int64_t** keys)
{
    const int64_t count = 6 * cleft_mesh_tet_count(mesh);
    int64_t* all = (int64_t*)malloc(sizeof(int64_t) * (size_t)count);
    for (int64_t i = 0; i < count; ++i) {
        const int32_t* tet = cleft_mesh_tets(mesh) + 4 * (i / 6);
        const int64_t a = tet[kEnds[i % 6][0]], b = tet[kEnds[i % 6][1]];
        all[i] = a < b ? a << 32 | b : b << 32 | a;
    }
    qsort(all, (size_t)count, sizeof *all, compare_keys);
    int64_t kept = 0;
    for (int64_t i = 0; i < count; ++i)
        if (i == 0 || all[i] != all[i - 1])
            all[kept++] = all[i];
    *keys = all;
    return kept;
}

/* Between the two nearest ranks of sorted values. */
static double at_share(const double* sorted, int64_t count, double share)
{
    const double rank = share * (double)(count - 1);
    const int64_t below = (int64_t)rank;
    return below + 1 < count ? sorted[below] + (rank - (double)below) * (sorted[below + 1] - sorted[below])
                             : sorted[count - 1];
}

static cleft_metric_quality measure(cleft_context* context, const cleft_mesh* mesh, const cleft_sizing* sizing)
{
    cleft_metric_quality one = {.struct_size = sizeof one}, three = {.struct_size = sizeof three};
    assert_ok(context, cleft_context_set_threads(context, 1));
    assert_ok(context, cleft_mesh_metric_quality(context, mesh, sizing, &one));
    assert_ok(context, cleft_context_set_threads(context, 3));
    assert_ok(context, cleft_mesh_metric_quality(context, mesh, sizing, &three));
    assert_memory_equal(&one, &three, sizeof one);
    return one;
}

/* Sizes across the layers of a metric along the axes: wanted lengths of 4 in a layer. */
static double across_at(int k) { return 1 + 0.3 * fabs(k + 0.5 - N / 2); }

/* The diagonal of the metric at a height: logarithms between the centres of voxels, constant beyond. */
static void layered_at(double z, double m[3])
{
    const double at = fmin(fmax(z - 0.5, 0), N - 1);
    const int low = (int)fmin(at, N - 2);
    const double rest = at - low;
    m[0] = m[1] = 1.0 / 16;
    m[2] = pow(across_at(low), -2 * (1 - rest)) * pow(across_at(low + 1), -2 * rest);
}

static cleft_sizing* layered_sizing(cleft_context* context, const cleft_volume* volume)
{
    double* tensors = (double*)malloc(sizeof(double) * 6 * kVoxels);
    for (int v = 0; v < kVoxels; ++v) {
        const double m[6] = {1.0 / 16, 0, 0, 1.0 / 16, 0, pow(across_at(v / (N * N)), -2)};
        memcpy(tensors + 6 * v, m, sizeof m);
    }
    cleft_sizing* sizing = NULL;
    assert_ok(context, cleft_sizing_create_metric(context, volume, CLEFT_TYPE_FLOAT64, tensors, 0, NULL, &sizing));
    free(tensors);
    return sizing;
}

static double length_by(const double m[3], const double* a, const double* b)
{
    double square = 0;
    for (int axis = 0; axis < 3; ++axis)
        square += m[axis] * (b[axis] - a[axis]) * (b[axis] - a[axis]);
    return sqrt(square);
}

static void check_lengths(const cleft_mesh* mesh, const cleft_metric_quality* q)
{
    int64_t* keys = NULL;
    int64_t in_range = 0;
    const int64_t count = edges_of(mesh, &keys);
    double* lengths = (double*)malloc(sizeof(double) * (size_t)count);
    for (int64_t e = 0; e < count; ++e) {
        const double* a = cleft_mesh_points(mesh) + 3 * (keys[e] >> 32);
        const double* b = cleft_mesh_points(mesh) + 3 * (keys[e] & 0xffffffff);
        double ma[3], mb[3];
        layered_at(a[2], ma);
        layered_at(b[2], mb);
        const double la = length_by(ma, a, b), lb = length_by(mb, a, b);
        lengths[e] = fabs(la - lb) > 1e-3 ? (la - lb) / log(la / lb) : (la + lb) / 2;
        in_range += lengths[e] >= sqrt(0.5) && lengths[e] <= sqrt(2);
    }
    qsort(lengths, (size_t)count, sizeof *lengths, compare_reals);
    assert_int_equal(q->edge_count, count);
    assert_true(llabs(q->edges_in_range - in_range) <= 2);
    assert_true(fabs(q->edge_least - lengths[0]) < 1e-5 && fabs(q->edge_greatest - lengths[count - 1]) < 1e-5);
    assert_true(fabs(q->edge_01 - at_share(lengths, count, 0.01)) < 1e-5);
    assert_true(fabs(q->edge_median - at_share(lengths, count, 0.5)) < 1e-5);
    assert_true(fabs(q->edge_99 - at_share(lengths, count, 0.99)) < 1e-5);
    free(lengths);
    free(keys);
}

static double six_volumes(double x[4][3])
{
    double e[3][3];
    for (int i = 0; i < 3; ++i)
        for (int axis = 0; axis < 3; ++axis)
            e[i][axis] = x[i + 1][axis] - x[0][axis];
    return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) - e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

/* The mean ratio; `mapped` gets the corners after the square root of the mean metric. */
static double look_at_tet(const cleft_mesh* mesh, int64_t t, double mapped[4][3])
{
    const double* corners[4];
    double m[4][3], greatest[3] = {0, 0, 0}, mean = 1, squares = 0, x[4][3];
    for (int i = 0; i < 4; ++i) {
        corners[i] = cleft_mesh_points(mesh) + 3 * (int64_t)cleft_mesh_tets(mesh)[4 * t + i];
        layered_at(corners[i][2], m[i]);
        if (m[i][2] > greatest[2])
            memcpy(greatest, m[i], sizeof greatest);
        mean *= pow(m[i][2], 0.25);
    }
    for (int e = 0; e < 6; ++e)
        squares += pow(length_by(greatest, corners[kEnds[e][0]], corners[kEnds[e][1]]), 2) / 6;
    for (int i = 0; i < 4; ++i)
        for (int axis = 0; axis < 3; ++axis) {
            x[i][axis] = corners[i][axis] * sqrt(greatest[axis]);
            mapped[i][axis] = corners[i][axis] * (axis == 2 ? sqrt(mean) : 0.25);
        }
    return pow(six_volumes(x) * sqrt(2), 2.0 / 3) / squares;
}

static void layers_are_measured_as_by_hand(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, N);
    cleft_sizing* sizing = layered_sizing(context, volume);
    cleft_mesh *mesh = NULL, *mapped = NULL;
    assert_ok(context, cleft_mesh_volume(context, volume, sizing, NULL, NULL, &mesh));
    const cleft_metric_quality q = measure(context, mesh, sizing);
    check_lengths(mesh, &q);

    const int64_t tets = cleft_mesh_tet_count(mesh);
    double* ratios = (double*)malloc(sizeof(double) * (size_t)tets);
    double* points = (double*)malloc(sizeof(double) * 12 * (size_t)tets);
    int32_t* corners = (int32_t*)malloc(sizeof(int32_t) * 4 * (size_t)tets);
    for (int64_t t = 0; t < tets; ++t) {
        double x[4][3];
        ratios[t] = look_at_tet(mesh, t, x);
        memcpy(points + 12 * t, x, sizeof x);
        for (int i = 0; i < 4; ++i)
            corners[4 * t + i] = (int32_t)(4 * t + i);
    }
    qsort(ratios, (size_t)tets, sizeof *ratios, compare_reals);
    assert_int_equal(q.tet_count, tets);
    assert_true(fabs(q.mean_ratio_least - ratios[0]) < 1e-5);
    assert_true(fabs(q.mean_ratio_01 - at_share(ratios, tets, 0.01)) < 1e-5);
    assert_true(fabs(q.mean_ratio_median - at_share(ratios, tets, 0.5)) < 1e-5);
    /* Each tetrahedron alone, where its metric is the identity. */
    assert_ok(context, cleft_mesh_create(context, 4 * tets, points, tets, corners, NULL, 0, &mapped));
    cleft_quality alone = {.struct_size = sizeof alone};
    assert_ok(context, cleft_mesh_quality(context, mapped, &alone));
    assert_true(fabs(q.min_dihedral - alone.min_dihedral) < 1e-3 && fabs(q.max_dihedral - alone.max_dihedral) < 1e-3);
    for (int bin = 0; bin < 36; ++bin)
        assert_true(llabs(q.dihedral_histogram[bin] - alone.dihedral_histogram[bin]) <= 4);
    free(corners);
    free(points);
    free(ratios);
    cleft_mesh_destroy(mapped);
    cleft_mesh_destroy(mesh);
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* What a constant metric measures is what anybody measures after a map by its square root, in a turned volume too. */
static void a_constant_metric_is_a_map(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    const double affine[12] = {0, -2, 0, 5, 2, 0, 0, -7, 0, 0, -2, 1};
    const int64_t dims[3] = {N, N, N};
    int32_t* labels = ball_labels(N);
    cleft_volume* volume = NULL;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_INT32, labels, dims, affine, NULL, &volume));
    free(labels);
    /* L L^T, of a lower triangle. */
    const double l[3][3] = {{0.2, 0, 0}, {0.05, 0.15, 0}, {-0.1, 0.02, 0.4}};
    double m[3][3] = {{0}};
    for (int i = 0; i < 9; ++i)
        for (int k = 0; k < 3; ++k)
            m[i / 3][i % 3] += l[i / 3][k] * l[i % 3][k];
    const double tensor[6] = {m[0][0], m[0][1], m[0][2], m[1][1], m[1][2], m[2][2]};
    cleft_sizing* sizing = NULL;
    cleft_mesh *mesh = NULL, *mapped = NULL;
    assert_ok(context, cleft_sizing_create_constant_metric(context, volume, tensor, &sizing));
    assert_ok(context, cleft_mesh_volume(context, volume, sizing, NULL, NULL, &mesh));
    const cleft_metric_quality q = measure(context, mesh, sizing);

    const int64_t count = cleft_mesh_point_count(mesh), tets = cleft_mesh_tet_count(mesh);
    double* points = (double*)calloc(3 * (size_t)count, sizeof(double));
    for (int64_t i = 0; i < 3 * count; ++i)
        for (int row = 0; row < 3; ++row)
            points[i] += l[row][i % 3] * cleft_mesh_points(mesh)[i - i % 3 + row];
    assert_ok(context, cleft_mesh_create(context, count, points, tets, cleft_mesh_tets(mesh), NULL, 0, &mapped));
    cleft_quality there = {.struct_size = sizeof there};
    assert_ok(context, cleft_mesh_quality(context, mapped, &there));
    assert_true(fabs(q.min_dihedral - there.min_dihedral) < 1e-3 && fabs(q.max_dihedral - there.max_dihedral) < 1e-3);
    assert_true(fabs(q.edge_least - there.min_edge) < 1e-5 && fabs(q.edge_greatest - there.max_edge) < 1e-5);
    for (int bin = 0; bin < 36; ++bin)
        assert_true(llabs(q.dihedral_histogram[bin] - there.dihedral_histogram[bin]) <= 4);
    assert_true(q.mean_ratio_least > 0 && q.mean_ratio_median > 0.7 && q.mean_ratio_median < 1);
    free(points);
    cleft_mesh_destroy(mapped);
    cleft_mesh_destroy(mesh);
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void what_cannot_be_measured_is_refused(void** state)
{
    (void)state;
    static const double points[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const int32_t good[4] = {0, 1, 2, 3}, turned[4] = {0, 2, 1, 3}, twice[4] = {0, 1, 2, 2};
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, 4);
    static const double identity[6] = {1, 0, 0, 1, 0, 1};
    cleft_sizing *sizes = NULL, *sizing = NULL;
    cleft_mesh* mesh = NULL;
    assert_ok(context, cleft_sizing_create_constant(context, volume, 1, &sizes));
    assert_ok(context, cleft_sizing_create_constant_metric(context, volume, identity, &sizing));
    cleft_metric_quality q = {.struct_size = sizeof q};
    assert_ok(context, cleft_mesh_create(context, 4, points, 1, good, NULL, 0, &mesh));
    assert_fails(context, CLEFT_ERROR_ARGUMENT, cleft_mesh_metric_quality(context, mesh, sizes, &q));
    assert_fails(context, CLEFT_ERROR_NULL, cleft_mesh_metric_quality(context, mesh, NULL, &q));
    assert_fails(context, CLEFT_ERROR_NULL, cleft_mesh_metric_quality(context, mesh, sizing, NULL));
    q.struct_size = sizeof q - 1;
    assert_fails(context, CLEFT_ERROR_ARGUMENT, cleft_mesh_metric_quality(context, mesh, sizing, &q));
    q = measure(context, mesh, sizing);
    assert_int_equal(q.edge_count, 6);
    assert_int_equal(q.edges_in_range, 6);
    const double ratio = q.mean_ratio_least;
    assert_true(ratio > 0.8 && ratio < 0.9);
    cleft_mesh_destroy(mesh);
    assert_ok(context, cleft_mesh_create(context, 4, points, 1, turned, NULL, 0, &mesh));
    q = measure(context, mesh, sizing);
    assert_true(q.mean_ratio_least == -ratio);
    cleft_mesh_destroy(mesh);
    assert_ok(context, cleft_mesh_create(context, 4, points, 1, twice, NULL, 0, &mesh));
    assert_fails(context, CLEFT_ERROR_INVALID_MESH, cleft_mesh_metric_quality(context, mesh, sizing, &q));
    cleft_mesh_destroy(mesh);
    assert_ok(context, cleft_mesh_create(context, 4, points, 0, NULL, NULL, 0, &mesh));
    q = measure(context, mesh, sizing);
    assert_true(q.tet_count == 0 && q.edge_count == 0 && q.max_dihedral == 0);
    cleft_mesh_destroy(mesh);
    cleft_sizing_destroy(sizing);
    cleft_sizing_destroy(sizes);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(layers_are_measured_as_by_hand),
        cmocka_unit_test(a_constant_metric_is_a_map),
        cmocka_unit_test(what_cannot_be_measured_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
