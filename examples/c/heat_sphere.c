/* Heat conduction in a ball of two materials, by linear finite elements on meshes of libcleft, against the exact
 * solution.
 *
 * A core of radius 0.5 conducts ten times better than the shell around it, of radius 1. Heat is made evenly everywhere,
 * the surface is held at its temperature. The temperature has a kink where the materials meet, which elements that lie
 * across that sphere could not follow; in a conforming mesh the error falls with the square of the edge length, and
 * that of the heat flux with its first power. The program halves the edge length twice and fails if the errors do not
 * fall so.
 *
 *     cc heat_sphere.c $(pkg-config --cflags --libs cleft) -lm -o heat_sphere && ./heat_sphere
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cleft/cleft.h>

#define CORE_RADIUS 0.5
#define RADIUS 1.0
#define SOURCE 6.0
static const double conductivity[] = {0, 1, 10}; /* by label: none outside, shell, core */
enum { OUTSIDE = 0, SHELL = 1, CORE = 2 };

typedef struct errors {
    double temperature; /* in the L2 norm, relative */
    double flux;        /* in the energy norm, relative */
} errors;

/* ------------------------------------------------------------------------------------------ the exact solution -- */

static double exact_temperature(double r)
{
    const double at_core = SOURCE / (6 * conductivity[SHELL]) * (RADIUS * RADIUS - CORE_RADIUS * CORE_RADIUS);
    if (r < CORE_RADIUS)
        return at_core + SOURCE / (6 * conductivity[CORE]) * (CORE_RADIUS * CORE_RADIUS - r * r);
    return SOURCE / (6 * conductivity[SHELL]) * (RADIUS * RADIUS - r * r);
}

/* ---------------------------------------------------------------------------------------------------- the mesh -- */

static void stop(cleft_context* context, cleft_status status)
{
    fprintf(stderr, "%s: %s\n", cleft_status_string(status), cleft_context_last_error(context));
    exit(1);
}

/* The ball as three indicator functions on a grid of spacing h; the largest is the material. */
static cleft_volume* make_volume(cleft_context* context, double h)
{
    const int64_t n = (int64_t)ceil(2.5 * RADIUS / h);
    const int64_t dims[3] = {n, n, n};
    const double first = -0.5 * h * (double)(n - 1);
    const double affine[12] = {h, 0, 0, first, 0, h, 0, first, 0, 0, h, first};
    const size_t count = (size_t)(n * n * n);
    float* fields[3];
    for (int m = 0; m < 3; ++m)
        fields[m] = malloc(count * sizeof(float));
    for (size_t v = 0; v < count; ++v) {
        const int64_t i = (int64_t)v % n, j = (int64_t)v / n % n, k = (int64_t)v / n / n;
        const double x = first + h * (double)i, y = first + h * (double)j, z = first + h * (double)k;
        const double r = sqrt(x * x + y * y + z * z);
        fields[OUTSIDE][v] = (float)(r - RADIUS);
        fields[SHELL][v] = (float)fmin(RADIUS - r, r - CORE_RADIUS);
        fields[CORE][v] = (float)(CORE_RADIUS - r);
    }
    cleft_volume* volume = NULL;
    const cleft_status status = cleft_volume_create_indicators(context, CLEFT_TYPE_FLOAT32, (const void* const*)fields,
                                                               3, dims, affine, NULL, &volume);
    for (int m = 0; m < 3; ++m)
        free(fields[m]);
    if (status)
        stop(context, status);
    return volume;
}

static cleft_mesh* make_mesh(cleft_context* context, double h)
{
    const int32_t outside = OUTSIDE;
    cleft_options* options = NULL;
    cleft_mesh* mesh = NULL;
    cleft_volume* volume = make_volume(context, h);
    cleft_status status = cleft_options_create(&options);
    if (!status)
        status = cleft_options_set_real(options, CLEFT_OPTION_SIZE, h);
    if (!status)
        status = cleft_options_set_strip(options, &outside, 1);
    if (!status)
        status = cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh);
    if (status)
        stop(context, status);
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    return mesh;
}

/* ------------------------------------------------------------------------------------------------ the elements -- */

/* Gradients of the four shape functions of a tetrahedron; gives its volume. */
static double shape_gradients(const double* points, const int32_t* corners, double gradients[4][3])
{
    double e[3][3]; /* edges from the first corner */
    for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d)
            e[c][d] = points[3 * corners[c + 1] + d] - points[3 * corners[0] + d];
    for (int c = 0; c < 3; ++c) {
        const double *a = e[(c + 1) % 3], *b = e[(c + 2) % 3];
        for (int d = 0; d < 3; ++d)
            gradients[c + 1][d] = a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3];
    }
    double six_volumes = 0;
    for (int d = 0; d < 3; ++d)
        six_volumes += e[0][d] * gradients[1][d];
    for (int d = 0; d < 3; ++d) {
        for (int c = 1; c < 4; ++c)
            gradients[c][d] /= six_volumes;
        gradients[0][d] = -gradients[1][d] - gradients[2][d] - gradients[3][d];
    }
    return six_volumes / 6;
}

/* 16 numbers a tetrahedron; `load` gets the heat made in it. */
static double* element_matrices(const cleft_mesh* mesh, double* load)
{
    const double* points = cleft_mesh_points(mesh);
    const int32_t *tets = cleft_mesh_tets(mesh), *labels = cleft_mesh_tet_labels(mesh);
    const int64_t count = cleft_mesh_tet_count(mesh);
    double* matrices = malloc((size_t)count * 16 * sizeof(double));
    for (int64_t t = 0; t < count; ++t) {
        double g[4][3];
        const double volume = shape_gradients(points, tets + 4 * t, g);
        for (int a = 0; a < 4; ++a) {
            load[tets[4 * t + a]] += SOURCE * volume / 4;
            for (int b = 0; b < 4; ++b)
                matrices[16 * t + 4 * a + b] =
                    conductivity[labels[t]] * volume * (g[a][0] * g[b][0] + g[a][1] * g[b][1] + g[a][2] * g[b][2]);
        }
    }
    return matrices;
}

static void multiply(const cleft_mesh* mesh, const double* matrices, const double* x, double* y)
{
    const int32_t* tets = cleft_mesh_tets(mesh);
    memset(y, 0, (size_t)cleft_mesh_point_count(mesh) * sizeof(double));
    for (int64_t t = 0; t < cleft_mesh_tet_count(mesh); ++t)
        for (int a = 0; a < 4; ++a)
            for (int b = 0; b < 4; ++b)
                y[tets[4 * t + a]] += matrices[16 * t + 4 * a + b] * x[tets[4 * t + b]];
}

/* ---------------------------------------------------------------------------------------------------- the solver -- */

static double dot(int64_t n, const double* x, const double* y)
{
    double sum = 0;
    for (int64_t i = 0; i < n; ++i)
        sum += x[i] * y[i];
    return sum;
}

/* Conjugate gradients with the diagonal as preconditioner. Where `held`, x keeps its value. */
static void solve(const cleft_mesh* mesh, const double* matrices, const double* load, const char* held, double* x)
{
    const int64_t n = cleft_mesh_point_count(mesh);
    const int32_t* tets = cleft_mesh_tets(mesh);
    double* work = calloc((size_t)n * 5, sizeof(double));
    double *r = work, *z = work + n, *p = work + 2 * n, *q = work + 3 * n, *diagonal = work + 4 * n;
    for (int64_t t = 0; t < cleft_mesh_tet_count(mesh); ++t)
        for (int a = 0; a < 4; ++a)
            diagonal[tets[4 * t + a]] += matrices[16 * t + 5 * a];

    multiply(mesh, matrices, x, q);
    for (int64_t i = 0; i < n; ++i) {
        r[i] = held[i] ? 0 : load[i] - q[i];
        p[i] = z[i] = r[i] / diagonal[i];
    }
    double rz = dot(n, r, z);
    const double enough = 1e-20 * rz;
    for (int step = 0; step < 10000 && rz > enough; ++step) {
        multiply(mesh, matrices, p, q);
        for (int64_t i = 0; i < n; ++i)
            if (held[i])
                q[i] = 0;
        const double alpha = rz / dot(n, p, q);
        for (int64_t i = 0; i < n; ++i) {
            x[i] += alpha * p[i];
            r[i] -= alpha * q[i];
            z[i] = r[i] / diagonal[i];
        }
        const double former = rz;
        rz = dot(n, r, z);
        for (int64_t i = 0; i < n; ++i)
            p[i] = z[i] + rz / former * p[i];
    }
    free(work);
}

/* ---------------------------------------------------------------------------------------------------- the errors -- */

static errors measure(const cleft_mesh* mesh, const double* temperature)
{
    const double* points = cleft_mesh_points(mesh);
    const int32_t *tets = cleft_mesh_tets(mesh), *labels = cleft_mesh_tet_labels(mesh);
    double wrong = 0, all = 0, wrong_flux = 0, all_flux = 0;
    for (int64_t t = 0; t < cleft_mesh_tet_count(mesh); ++t) {
        const int32_t* corners = tets + 4 * t;
        double g[4][3], slope[3] = {0, 0, 0};
        const double volume = shape_gradients(points, corners, g), k = conductivity[labels[t]];
        for (int a = 0; a < 4; ++a)
            for (int d = 0; d < 3; ++d)
                slope[d] += temperature[corners[a]] * g[a][d];
        for (int q = 0; q < 4; ++q) { /* the four points of the quadrature of degree 2 */
            double x[3] = {0, 0, 0}, found = 0;
            for (int a = 0; a < 4; ++a) {
                const double weight = a == q ? 0.5854101966249685 : 0.1381966011250105;
                found += weight * temperature[corners[a]];
                for (int d = 0; d < 3; ++d)
                    x[d] += weight * points[3 * corners[a] + d];
            }
            const double truth = exact_temperature(sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]));
            wrong += volume / 4 * (found - truth) * (found - truth);
            all += volume / 4 * truth * truth;
            for (int d = 0; d < 3; ++d) {
                const double true_slope = -SOURCE / (3 * k) * x[d];
                wrong_flux += volume / 4 * k * (slope[d] - true_slope) * (slope[d] - true_slope);
                all_flux += volume / 4 * k * true_slope * true_slope;
            }
        }
    }
    return (errors){sqrt(wrong / all), sqrt(wrong_flux / all_flux)};
}

static errors errors_of_size(cleft_context* context, double h)
{
    cleft_mesh* mesh = make_mesh(context, h);
    cleft_surface* surface = NULL;
    const cleft_status status = cleft_surface_create(context, mesh, &surface);
    if (status)
        stop(context, status);

    const size_t n = (size_t)cleft_mesh_point_count(mesh);
    double* temperature = calloc(n, sizeof(double));
    double* load = calloc(n, sizeof(double));
    char* held = calloc(n, 1);
    const int32_t* hull = cleft_surface_hull_triangles(surface);
    for (int64_t c = 0; c < 3 * cleft_surface_hull_count(surface); ++c)
        held[hull[c]] = 1; /* at 0, as calloc left it */

    double* matrices = element_matrices(mesh, load);
    solve(mesh, matrices, load, held, temperature);
    const errors found = measure(mesh, temperature);
    printf("%8.4f %10lld   %.3e   %.3e\n", h, (long long)cleft_mesh_tet_count(mesh), found.temperature, found.flux);

    free(matrices);
    free(held);
    free(load);
    free(temperature);
    cleft_surface_destroy(surface);
    cleft_mesh_destroy(mesh);
    return found;
}

int main(void)
{
    cleft_context* context = NULL;
    if (cleft_context_create(&context))
        return 1;
    puts("    edge tetrahedra  temperature   heat flux");
    const errors coarse = errors_of_size(context, 0.4);
    errors_of_size(context, 0.2);
    const errors fine = errors_of_size(context, 0.1);
    cleft_context_destroy(context);

    const double order = log2(coarse.temperature / fine.temperature) / 2;
    const double flux_order = log2(coarse.flux / fine.flux) / 2;
    printf("orders of convergence: %.2f and %.2f\n", order, flux_order);
    return order > 1.7 && flux_order > 0.85 && fine.temperature < 0.01 ? 0 : 1;
}
