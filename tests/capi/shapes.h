/* Volumes of shapes whose distance is known: a ball, and a plane that cuts it in two. */
#ifndef CLEFT_TESTS_SHAPES_H
#define CLEFT_TESTS_SHAPES_H

#include "support/capi.h"

#include <math.h>

/* n^3 voxels whose centres lie at whole numbers, and the ball in their middle, in voxels. */
typedef struct scene {
    int n;
    double radius;
    double affine[12];
} scene;

/* Positive inside. */
typedef double (*shape)(const scene* s, const double x[3]);

/* The middle of the ball is at no voxel. */
static inline void middle_of(const scene* s, double middle[3])
{
    middle[0] = 0.5 * s->n + 0.2;
    middle[1] = 0.5 * s->n - 0.3;
    middle[2] = 0.5 * s->n + 0.4;
}

static inline double distance_between(const double x[3], const double y[3])
{
    const double d[3] = {x[0] - y[0], x[1] - y[1], x[2] - y[2]};
    return sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

static inline double ball(const scene* s, const double x[3])
{
    double middle[3];
    middle_of(s, middle);
    return s->radius - distance_between(x, middle);
}

static inline double plane(const scene* s, const double x[3])
{
    const double half = 0.5 * s->n;
    return (0.2 * (x[0] - half) + 0.3 * (x[1] - half) + (x[2] - half)) / sqrt(1.13);
}

static inline double outside_ball(const scene* s, const double x[3]) { return -ball(s, x); }
static inline double upper_half(const scene* s, const double x[3]) { return fmin(ball(s, x), plane(s, x)); }
static inline double lower_half(const scene* s, const double x[3]) { return fmin(ball(s, x), -plane(s, x)); }

/* Up to three shapes as indicator functions. */
static inline cleft_volume* volume_of_shapes(cleft_context* context, const scene* s, const shape* shapes, int count)
{
    const int n = s->n;
    const int64_t dims[3] = {n, n, n};
    float* fields[3] = {NULL, NULL, NULL};
    for (int f = 0; f < count; ++f) {
        fields[f] = (float*)malloc(sizeof(float) * (size_t)(n * n * n));
        for (int v = 0; v < n * n * n; ++v) {
            const double x[3] = {v % n, v / n % n, v / n / n};
            fields[f][v] = (float)shapes[f](s, x);
        }
    }
    cleft_volume* volume = NULL;
    assert_ok(context, cleft_volume_create_indicators(context, CLEFT_TYPE_FLOAT32, (const void* const*)fields, count,
                                                      dims, s->affine, NULL, &volume));
    for (int f = 0; f < count; ++f)
        free(fields[f]);
    return volume;
}

#endif
