/* What tests of pictures share: a mesh in a mesh, its picture, and what a pixel shows. libpng reads pictures back. */
#ifndef PICTURES_H
#define PICTURES_H

#include "folder_fixture.h"

#include <png.h>

enum { SIDE = 120 };
enum { OUTER = 1, INNER = 2 };

typedef struct picture {
    int width, height;
    uint8_t* rgba; /* four bytes a pixel */
} picture;

static inline cleft_io_picture small_picture(void)
{
    const cleft_io_picture look = {.struct_size = sizeof look, .width = SIDE, .height = SIDE};
    return look;
}

static inline picture read_png(const char* path)
{
    png_image image = {.version = PNG_IMAGE_VERSION};
    assert_true(png_image_begin_read_from_file(&image, path));
    image.format = PNG_FORMAT_RGBA;
    picture out = {(int)image.width, (int)image.height, malloc(PNG_IMAGE_SIZE(image))};
    assert_true(png_image_finish_read(&image, NULL, out.rgba, 0, NULL));
    return out;
}

static inline const uint8_t* pixel_at(const picture* p, int x, int y) { return p->rgba + 4 * (y * p->width + x); }
static inline const uint8_t* middle_of(const picture* p) { return pixel_at(p, p->width / 2, p->height / 2); }

/* The hues of labels 1 and 2, in any light. */
static inline int is_sky_blue(const uint8_t* c) { return c[2] > c[1] && c[1] > c[0] && c[2] > c[0] + 40; }
static inline int is_orange(const uint8_t* c) { return c[0] > c[1] && c[1] > c[2] && c[0] > c[2] + 40; }
static inline int is_grey(const uint8_t* c) { return abs(c[0] - c[2]) < 20 && abs(c[0] - c[1]) < 20; }
static inline int is_color(const uint8_t* c, int red, int green, int blue)
{
    return c[0] == red && c[1] == green && c[2] == blue;
}

static inline int64_t count_if(const picture* p, int (*holds)(const uint8_t*))
{
    int64_t count = 0;
    for (int i = 0; i < p->width * p->height; ++i)
        count += holds(p->rgba + 4 * i);
    return count;
}

/* A box of n x n x n cubes of six tetrahedra; label INNER where no cube is at the wall. `map` moves the points. */
static inline cleft_mesh* make_box(cleft_context* context, int n, double (*map)(double))
{
    static const int paths[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
    const int m = n + 1;
    double* points = malloc(sizeof(double) * 3 * (size_t)(m * m * m));
    int32_t* tets = malloc(sizeof(int32_t) * 24 * (size_t)(n * n * n));
    int32_t* labels = malloc(sizeof(int32_t) * 6 * (size_t)(n * n * n));
    for (int p = 0; p < m * m * m; ++p) {
        points[3 * p] = map(p % m);
        points[3 * p + 1] = map(p / m % m);
        points[3 * p + 2] = map(p / m / m);
    }
    for (int c = 0; c < n * n * n; ++c) {
        const int i = c % n, j = c / n % n, k = c / n / n;
        const int low = i < j ? (i < k ? i : k) : (j < k ? j : k), high = i > j ? (i > k ? i : k) : (j > k ? j : k);
        for (int t = 0; t < 6; ++t) {
            for (int v = 0; v < 4; ++v) {
                const int corner = paths[t][v];
                tets[24 * c + 4 * t + v] = i + (corner & 1) + m * (j + (corner >> 1 & 1) + m * (k + (corner >> 2)));
            }
            labels[6 * c + t] = low > 0 && high < n - 1 ? INNER : OUTER;
        }
    }
    cleft_mesh* mesh = NULL;
    assert_int_equal(cleft_mesh_create(context, m * m * m, points, 6 * n * n * n, tets, labels, 0, &mesh), CLEFT_OK);
    free(points);
    free(tets);
    free(labels);
    return mesh;
}

static inline double as_it_is(double x) { return x; }

static inline picture draw_some(fixture* f, const cleft_mesh* mesh, const cleft_io_picture* look, int32_t strip,
                                int32_t whole)
{
    const char* path = path_of(f, "a.png");
    const cleft_status status =
        cleft_io_write_picture(f->context, mesh, &strip, strip != 0, &whole, whole != 0, look, path);
    if (status != CLEFT_OK)
        fail_msg("%s", cleft_context_last_error(f->context));
    return read_png(path);
}

static inline picture draw(fixture* f, const cleft_mesh* mesh, const cleft_io_picture* look)
{
    return draw_some(f, mesh, look, 0, 0);
}

/* Text, whose strokes cover few pixels as a whole. */
static inline int is_ink(const uint8_t* c) { return c[0] < 110 && is_grey(c); }

static inline void assert_same(const picture* a, const picture* b)
{
    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    assert_memory_equal(a->rgba, b->rgba, 4 * (size_t)(a->width * a->height));
}

#endif
